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

/// A sheet with waves of so many along u and v, of this height.
PatchAssembly rippled(double waves, double height) {
	return assembled(jitteredGrid(41, 41, [=](double u, double v) {
		return Eigen::Vector3d(
			u, v, height * std::sin(2 * pi * waves * u + 0.3) * std::sin(2 * pi * waves * v + 0.7));
	}));
}

/// The share of a shape's heights that is left where a coarse level of 400 places smooths it.
double shareLeft(const PatchAssembly& fine) {
	const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(400);
	detail::BendingMatrix bending(fine);
	const detail::Prolongation prolongation(fine, coarse, bending, {});
	const Positions smooth = fine.originalPositions + prolongation.smoothing(fine.originalPositions);
	return smooth.row(2).norm() / fine.originalPositions.row(2).norm();
}

TEST(Prolongation, SmoothsWavesThatTheCoarseLevelDoesNotHave) {
	EXPECT_GT(shareLeft(rippled(0.5, 0.1)), 0.97);
	EXPECT_LT(shareLeft(rippled(8, 0.005)), 0.4);
}

TEST(Prolongation, SmoothsNothingOfWhatIsFlatAndNothingThatIsHeldStill) {
	PatchAssembly fine = assembled(jitteredGrid(31, 31, flatSheet));
	for (int place = 0; place < fine.placeCount(); ++place)
		fine.placeFixed[place] = fine.originalPositions(0, place) < 0.4;
	const PartialAssembly coarse = detail::Coarsening(fine, {}).coarsen(300);
	detail::BendingMatrix bending(fine);
	const detail::Prolongation prolongation(fine, coarse, bending, {});
	EXPECT_LT(prolongation.smoothing(fine.originalPositions).cwiseAbs().maxCoeff(), 1e-9);
	Positions rippled = fine.originalPositions;
	for (int place = 0; place < fine.placeCount(); ++place)
		rippled(2, place) = 0.01 * std::sin(50 * rippled(0, place)) * std::sin(50 * rippled(1, place));
	const Positions smoothing = prolongation.smoothing(rippled);
	EXPECT_GT(smoothing.cwiseAbs().maxCoeff(), 5e-3);
	for (int place = 0; place < fine.placeCount(); ++place)
		if (fine.placeFixed[place]) {
			EXPECT_EQ(smoothing.col(place).norm(), 0);
		}
}

} // namespace
} // namespace developable::test
