// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.h: how long a displacement is: how far it moves the surface, and how much it bends.
#pragma once

#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"
#include "newton_tuning.h"

namespace developable::detail {

/// The area of each triangle.
Eigen::VectorXd triangleAreas(const PatchAssembly& assembly, const Positions& positions);

/// m_q, the share that each place has of the whole area: a third of the triangles round it.
Eigen::VectorXd placeMasses(const PatchAssembly& assembly);

/// How dear it is to bend, beside to move. Numbers without unit, which mean the same on a model of any size
/// and tessellation.
struct Smoothness {
	Eigen::VectorXd ofPatches; ///< α, per patch: against the patch's own area
	double ofPart = 0;         ///< φ: against the area of the part that hangs together
};

/// Puts together the matrix of a squared length of displacements, (Σ_q m_q |d_q|² + Σ_p (α A_p² + φ A_o²) ∫_p
/// |d''|²) / A: A_p is the area of patch p, A_o that of the part that it belongs to, A that of all patches,
/// and the integral that of FittedHessian. Rows of places that are held still are those of a diagonal matrix.
class BendingMatrix {
public:
	/// \param masses  m_q / A, per place
	/// \param rods    β / (α + φ); 0: no rods
	BendingMatrix(const PatchAssembly& assembly, const Eigen::VectorXd& masses, const Smoothness& smoothness,
				  double rods);

	/// Its lower triangle.
	SparseMatrix lower() const;

private:
	using Entry = Eigen::Triplet<double>;

	void addPlates(const Smoothness& smoothness);

	void addRods(const Smoothness& smoothness, double rods);

	/// Adds the squared norm of weight · rows · (values at the places).
	template <class Rows>
	void addSquares(const std::vector<int>& places, const Rows& rows, double weight,
					std::vector<Entry>& entries) const;

	const PatchAssembly& assembly_;
	const Eigen::VectorXd areas_;    // of the triangles
	const Eigen::VectorXd partArea_; // A_o, per place
	std::vector<Entry> entries_;
};

/// The metric W of the constrained Newton method: a BendingMatrix with the places' own masses. Triangles can
/// be made stiffer.
class BendingMetric {
public:
	/// \param memoryLimit  see SparseSolver
	BendingMetric(const PatchAssembly& assembly, const NewtonTuning& tuning, double memoryLimit);

	/// The metric anew: every triangle is as stiff as at first.
	void setSmoothness(const Smoothness& smoothness);

	/// Makes triangles move rather as one piece: adds Σ ρ_t |d_i − d_j|² over their edges, with ρ_t a share
	/// of what moving a corner costs, and some times as much each time again. Calls for another
	/// factorisation.
	void stiffen(const std::vector<int>& triangles);

	/// Every triangle is as stiff as at first again, and places stay as heavy as they are. Calls for another
	/// factorisation. \return whether any was stiffer
	bool loosen();

	/// Makes places heavier: adds Σ_q mass_q |d_q|². Calls for another factorisation.
	void weigh(const Eigen::VectorXd& masses);

	/// Whether so many triangles are stiffer that they are no accidents of the triangulation: then the shape
	/// itself needs a cut.
	bool tooStiff() const;

	/// Has to be called before solve. \return false where rounding spoils the system
	bool factorize();

	/// m_q.
	const Eigen::VectorXd& placeMass() const { return placeMass_; }
	/// m_q with what places have been made heavier by.
	const Eigen::VectorXd& weight() const { return weight_; }

	/// The lower triangle of W, the same for all three coordinates.
	const SparseMatrix& matrix() const { return lower_; }

	/// W d.
	Positions apply(const Positions& displacement) const;

	/// W⁻¹ f; f must be zero at places that are held still.
	Positions solve(const Positions& force) const;

	double squaredNorm(const Positions& displacement) const;

	/// B x, B being what of W is bending, of places held still, too; 0 at those themselves.
	Positions bendingForce(const Positions& positions, const Smoothness& smoothness) const;

private:
	/// Adds stiffness · |d_i − d_j|² for two places of a triangle, of which held ones have d = 0. The matrix
	/// has entries for them where the triangle has a neighbour.
	void addSpring(int i, int j, double stiffness);

	const PatchAssembly& assembly_;
	const NewtonTuning tuning_;
	Eigen::VectorXd placeMass_, weight_;
	SparseMatrix lower_;
	SparseMatrix loose_;        // the same without what triangles are stiffer by, once any is
	Eigen::VectorXd diagonal_;  // of the matrix at first
	Eigen::VectorXd stiffness_; // ρ, per triangle
	SparseSolver factorization_;
};

} // namespace developable::detail
