// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/coarsening.h"
#include "developable/newton/prolongation.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

TEST(Prolongation, KeepsAffineDisplacements) {
	const PatchAssembly fine = sewnPatches(31);
	const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(500);
	Eigen::Matrix3d slope;
	slope << 0.3, -0.2, 1, 0.5, 0.1, 0.4, -0.7, 0.2, 0.6;
	const Positions expected = slope * fine.originalPositions;
	detail::BendingMatrix bending(fine);
	const Positions result =
		detail::Prolongation(fine, coarse, bending, {}).of(expected(Eigen::all, coarse.wholePlace));
	EXPECT_LT((result - expected).cwiseAbs().maxCoeff(),
			  0.02); // of 1: the surface is curved, so not quite free
	const PatchAssembly sheet = assembled(jitteredGrid(31, 31, flatSheet));
	const PartialAssembly coarseSheet = detail::Coarsening(sheet, {}).coarsen(300);
	const Positions affine = slope * sheet.originalPositions;
	detail::BendingMatrix ofSheet(sheet);
	const Positions carried =
		detail::Prolongation(sheet, coarseSheet, ofSheet, {}).of(affine(Eigen::all, coarseSheet.wholePlace));
	EXPECT_LT((carried - affine).cwiseAbs().maxCoeff(), 1e-4);
}

} // namespace
} // namespace developable::test
