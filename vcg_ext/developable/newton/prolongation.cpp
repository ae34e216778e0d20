// SPDX-License-Identifier: GPL-3.0-or-later
// prolongation.cpp: the smoothest displacement that fits a coarse one.
#include "prolongation.h"

namespace developable::detail {

Positions prolonged(const PatchAssembly& fine, const PartialAssembly& coarse,
					const Positions& coarseDisplacement, const NewtonTuning& tuning, double memoryLimit) {
	const int coarseCount = coarse.assembly.placeCount();
	const Eigen::VectorXd coarseMasses = placeMasses(coarse.assembly);
	// A trifle of mass everywhere holds what the coarse places leave free.
	Eigen::VectorXd masses = tuning.prolongationMass * placeMasses(fine);
	Eigen::MatrixX3d pull = Eigen::MatrixX3d::Zero(fine.placeCount(), 3);
	for (int place = 0; place < coarseCount; ++place) {
		masses[coarse.wholePlace[place]] += coarseMasses[place];
		pull.row(coarse.wholePlace[place]) = coarseMasses[place] * coarseDisplacement.col(place).transpose();
	}
	const Eigen::VectorXd smoothness = Eigen::VectorXd::Constant(
		fine.patchCount(), tuning.prolongationBending / (double(coarseCount) * coarseCount));
	const SparseMatrix matrix = BendingMatrix(fine, masses, {smoothness}, 0).lower();
	SparseSolver solver(memoryLimit);
	if (!solver.factorize(matrix))
		return Positions::Zero(3, fine.placeCount());
	return solver.solve(Eigen::MatrixXd(pull)).transpose();
}

} // namespace developable::detail
