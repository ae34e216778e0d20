// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.h: how long a displacement is: how far it moves the surface, and how much it bends.
#pragma once

#include "bending_matrix.h"
#include "newton_tuning.h"

namespace developable::detail {

/// The metric W of the constrained Newton method: a BendingMatrix with the places' own masses. Triangles can
/// be made stiffer.
class BendingMetric {
public:
	/// \param memoryLimit  see SparseSolver
	BendingMetric(const PatchAssembly& assembly, const NewtonTuning& tuning, double memoryLimit);

	/// What can be found once for all metrics of one assembly is taken over from another that has found it.
	void takeOver(const BendingMetric& other);

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

	/// To be called before the first factorisation, which else finds an order.
	/// \param order  see there; of all places
	void eliminateIn(std::vector<int> order);
	/// Empty unless it was given.
	const std::vector<int>& eliminationOrder() const { return eliminationOrder_; }

	/// What the metric is made of.
	BendingMatrix& bending() { return bending_; }

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

	/// See BendingMatrix::force.
	Positions bendingForce(const Positions& positions, const Smoothness& smoothness);

private:
	/// Adds stiffness · |d_i − d_j|² for two places of a triangle, of which held ones have d = 0. The matrix
	/// has entries for them where the triangle has a neighbour.
	void addSpring(int i, int j, double stiffness);

	const PatchAssembly& assembly_;
	const NewtonTuning tuning_;
	BendingMatrix bending_;
	std::vector<int> eliminationOrder_;
	Eigen::VectorXd placeMass_, weight_;
	SparseMatrix lower_;
	SparseMatrix loose_;        // the same without what triangles are stiffer by, once any is
	Eigen::VectorXd diagonal_;  // of the matrix at first
	Eigen::VectorXd stiffness_; // ρ, per triangle
	SparseSolver factorization_;
};

} // namespace developable::detail
