// SPDX-License-Identifier: GPL-3.0-or-later
// prolongation.cpp: the smoothest displacement that fits a coarse one.
#include "prolongation.h"

namespace developable::detail {

namespace {

/// Relative to each patch's area, like that of a metric.
Smoothness coarseSmoothness(const PatchAssembly& fine, const PatchAssembly& coarse,
							const NewtonTuning& tuning) {
	const double coarseCount = coarse.placeCount();
	return {Eigen::VectorXd::Constant(fine.patchCount(),
									  tuning.prolongationBending / (coarseCount * coarseCount))};
}

} // namespace

Prolongation::Prolongation(const PatchAssembly& fine, const PartialAssembly& coarse, BendingMatrix& bending,
						   const NewtonTuning& tuning, const std::vector<int>& placeOrder, double memoryLimit)
	: bending_(bending), smoothness_(coarseSmoothness(fine, coarse.assembly, tuning)),
	  placeOfCoarse_(coarse.wholePlace), coarseMasses_(placeMasses(coarse.assembly)),
	  places_(fine.placeCount()), solver_(memoryLimit) {
	// A trifle of mass everywhere holds what the coarse places leave free.
	Eigen::VectorXd masses = tuning.prolongationMass * placeMasses(fine);
	masses(placeOfCoarse_) += coarseMasses_;
	const SparseMatrix matrix = bending.lower(masses, smoothness_, 0);
	solver_.prepare(matrix, placeOrder);
	solvable_ = solver_.factorize(matrix);
}

Positions Prolongation::of(const Positions& coarseDisplacement) const {
	if (!solvable_)
		return Positions::Zero(3, places_);
	Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(places_, 3);
	for (std::size_t place = 0; place < placeOfCoarse_.size(); ++place)
		pull.row(placeOfCoarse_[place]) = coarseMasses_[place] * coarseDisplacement.col(place).transpose();
	return solver_.solve(pull).transpose();
}

Positions Prolongation::smoothing(const Positions& positions) const {
	if (!solvable_)
		return Positions::Zero(3, places_);
	const Positions force = bending_.force(positions, smoothness_, 0);
	return -solver_.solve(Eigen::MatrixXd(force.transpose())).transpose();
}

} // namespace developable::detail
