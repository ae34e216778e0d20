// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that are sewn together come closer than the preferred displacement where few places need it.
#include "developable/newton/closer_runs.h"

#include "developable/newton/displacement_metric.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

/// Two mirror images, sewn together.
PatchAssembly mirrored(const Surface& surface, double height) {
	const TriangleMesh left = jitteredGrid(25, 25, [&](double u, double v) {
		return Eigen::Vector3d(Eigen::Vector3d(1, 1, height).cwiseProduct(surface(u, v)));
	});
	TriangleMesh right = left;
	right.positions.row(0) = 2 * left.positions.row(0).maxCoeff() - right.positions.row(0).array();
	return assembled(together(left, right));
}

Positions solved(const PatchAssembly& assembly, int tries) {
	ConstrainedNewtonOptions options;
	options.tuning.closerTries = tries;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
	return positions;
}

TEST(CloserRuns, bringTheFarthestPlacesNearerAndOthersHardlyFarther) {
	for (const auto& [surface, height] : {std::make_pair(Surface(saddle), 1.0), {Surface(wave), 1.5}}) {
		const PatchAssembly assembly = mirrored(surface, height);
		const Positions before = solved(assembly, 0), closer = solved(assembly, 3);
		EXPECT_LT(farthestMove(assembly, closer), 0.8 * farthestMove(assembly, before));
		EXPECT_LT(meanDisplacement(assembly, closer), 1.05 * meanDisplacement(assembly, before));
		expectSound(assembly, closer);
		EXPECT_EQ(closer, solved(assembly, 3));
	}
}

/// Where many places are far away there is nothing to be tried, nor with a single panel.
TEST(CloserRuns, areSparedWhereTheyWouldHardlyLeadCloser) {
	for (const PatchAssembly& assembly :
		 {mirrored(largeSaddle, 1), assembled(jitteredGrid(25, 25, bumpedCylinder))})
		EXPECT_EQ(solved(assembly, 0), solved(assembly, 3));
	const PatchAssembly near = mirrored(saddle, 0.1);
	EXPECT_EQ(solved(near, 0), solved(near, 3));
}

TEST(CloserRuns, stopWhenTheyAreTold) {
	const PatchAssembly assembly = mirrored(saddle, 1);
	Positions positions = assembly.originalPositions;
	bool begun = false;
	const ConstrainedNewtonReport report =
		constrainedNewton(assembly, positions, {}, [&](double, const std::string& message) {
			begun = begun || message.find("closer: ") != std::string::npos;
			return !begun;
		});
	EXPECT_TRUE(begun);
	EXPECT_EQ(report.status, Status::Stopped);
}

/// What a run without a bound does one with it can do as well.
TEST(BoundOfSewnPanels, isKeptWhereItIsByDefault) {
	for (const auto& [surface, height] : {std::make_pair(Surface(vamp), 1.0), {Surface(saddle), 2.0}}) {
		const PatchAssembly assembly = mirrored(surface, height);
		ConstrainedNewtonOptions options;
		options.maxDisplacement = 0.02 * boxDiagonal(assembly.originalPositions);
		ASSERT_LE(farthestMove(assembly, solved(assembly, 0)), options.maxDisplacement);
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
		EXPECT_LE(farthestMove(assembly, positions), options.maxDisplacement);
		expectSound(assembly, positions);
	}
}

TEST(BoundOfSewnPanels, isKeptWhenARunIsStopped) {
	const PatchAssembly assembly = mirrored(largeSaddle, 1);
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.002 * boxDiagonal(assembly.originalPositions);
	for (const int calls : {3, 10, 20}) {
		Positions positions = assembly.originalPositions;
		int left = calls;
		const auto stop = [&](double, const std::string&) { return --left > 0; };
		EXPECT_EQ(constrainedNewton(assembly, positions, options, stop).status, Status::Stopped);
		EXPECT_LE(farthestMove(assembly, positions), options.maxDisplacement);
	}
}

TEST(CloserRuns, haveTheSameBoundsWhateverIsPreferred) {
	const PatchAssembly assembly = mirrored(saddle, 1);
	NewtonTuning tuning;
	tuning.closerStep = 0.5;
	const double first = tuning.preferredMove * boxDiagonal(assembly.originalPositions);
	EXPECT_DOUBLE_EQ(detail::boundWithin(assembly, tuning), first);
	for (const auto& [length, bound] : {std::make_pair(1.0, 1.0), {0.99, 0.5}, {0.5, 0.5}, {0.13, 0.125}}) {
		tuning.preferredLength = length * first;
		EXPECT_DOUBLE_EQ(detail::boundWithin(assembly, tuning), bound * first);
	}
}

} // namespace
} // namespace developable::test
