// SPDX-License-Identifier: GPL-3.0-or-later
// bending_matrix.h: the matrix of a length of displacements: how far they move a surface, and how much they
// bend it.
#pragma once

#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"

#include <memory>

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

/// Puts together matrices of a squared length of displacements, (Σ_q m_q |d_q|² + Σ_p (α A_p² + φ A_o²) ∫_p
/// |d''|²) / A: A_p is the area of patch p, A_o that of the part that it belongs to, A that of all patches,
/// and the integral that of FittedHessian. Rows of places that are held still are those of a diagonal matrix.
class BendingMatrix {
public:
	/// \param assembly  kept as a reference
	explicit BendingMatrix(const PatchAssembly& assembly);

	/// What was found already of the same assembly.
	void takeOver(const BendingMatrix& other) { unitPlates_ = other.unitPlates_; }

	/// Its lower triangle.
	/// \param masses  m_q / A, per place
	/// \param rods    β / (α + φ); 0: no rods
	SparseMatrix lower(const Eigen::VectorXd& masses, const Smoothness& smoothness, double rods);

	/// B x, B being what of it is bending, of places held still, too; 0 at those themselves.
	Positions force(const Positions& positions, const Smoothness& smoothness, double rods);

private:
	using Entry = Eigen::Triplet<double>;

	SparseMatrix plates(const Smoothness& smoothness);
	SparseMatrix plates(const Eigen::VectorXd& weights) const;
	SparseMatrix plates() const;
	SparseMatrix rods(const Smoothness& smoothness, double rods) const;
	SparseMatrix sum(const std::vector<Entry>& entries) const;

	/// Adds the squared norm of weight · rows · (values at the places).
	template <class Rows>
	void addSquares(const std::vector<int>& places, const Rows& rows, double weight,
					std::vector<Entry>& entries) const;

	const PatchAssembly& assembly_;
	const Eigen::VectorXd areas_;    // of the triangles
	const Eigen::VectorXd partArea_; // A_o, per place
	/// Plates with α = 1 in every patch and φ = 0, once a multiple of them has been asked for.
	std::shared_ptr<const SparseMatrix> unitPlates_;
};

} // namespace developable::detail
