// SPDX-License-Identifier: GPL-3.0-or-later
// prolongation.h: from the displacement of a coarse assembly to one of the fine assembly.
#pragma once

#include "bending_metric.h"
#include "coarsening.h"
#include "sparse_solver.h"

namespace developable::detail {

/// The displacement of all fine places that is nearest to a coarse one without bending on the scale of the
/// coarse edges: with m_c the masses of the coarse places and n_c their number, it has the least
///     Σ_c m_c |d_c − d̂_c|² + β ∫|d''|²,   β = 0.3 (A/n_c)²,
/// so waves shorter than some five coarse edges are left out: they belong to the coarse triangulation.
/// \param memoryLimit  see SparseSolver
/// \return             3 x fine places
inline Positions prolonged(const PatchAssembly& fine, const PartialAssembly& coarse,
						   const Positions& coarseDisplacement, double memoryLimit = 0) {
	const int coarseCount = coarse.assembly.placeCount();
	const Eigen::VectorXd coarseMasses = placeMasses(coarse.assembly);
	// A trifle of mass everywhere holds what the coarse places leave free.
	Eigen::VectorXd masses = 1e-6 * placeMasses(fine);
	Eigen::MatrixX3d pull = Eigen::MatrixX3d::Zero(fine.placeCount(), 3);
	for (int place = 0; place < coarseCount; ++place) {
		masses[coarse.wholePlace[place]] += coarseMasses[place];
		pull.row(coarse.wholePlace[place]) = coarseMasses[place] * coarseDisplacement.col(place).transpose();
	}
	const Eigen::VectorXd smoothness =
		Eigen::VectorXd::Constant(fine.patchCount(), 0.3 / (double(coarseCount) * coarseCount));
	SparseSolver solver(memoryLimit);
	if (!solver.factorize(BendingMatrix(fine, masses, smoothness).lower()))
		return Positions::Zero(3, fine.placeCount());
	return solver.solve(Eigen::MatrixXd(pull)).transpose();
}

} // namespace developable::detail
