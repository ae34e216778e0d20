// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/normal_steps.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

TEST(NormalSystem, IsTheProductThatItStandsFor) {
	const PatchAssembly assembly = sewnPatches(12);
	detail::BendingMetric metric(assembly, {}, 0);
	metric.setSmoothness({Eigen::VectorXd::Constant(assembly.patchCount(), 1e-4)});
	detail::DefectJacobian jacobian(assembly, metric.placeMass(), 0.1);
	detail::NormalSystem system(0), inCoordinates(0);
	for (const double noise : {0.0, 0.01}) { // the second time with the pattern of the first
		const Positions positions =
			assembly.originalPositions + noise * Positions::Random(3, assembly.placeCount());
		jacobian.linearize(positions);
		const Positions normals = placeNormals(assembly, positions);
		const Eigen::MatrixXd along = jacobian.along(normals).toDense();
		const Eigen::MatrixXd w = SparseMatrix(metric.matrix().selfadjointView<Eigen::Lower>());
		const Eigen::MatrixXd expected =
			along.transpose() * along + 0.3 * w.cwiseProduct(normals.transpose() * normals);
		ASSERT_TRUE(system.factorize(jacobian.along(normals), normals, metric.matrix(), 0.3));
		const Eigen::MatrixXd found = system.lower().toDense();
		const Eigen::MatrixXd lower = expected.triangularView<Eigen::Lower>();
		EXPECT_LT((found - lower).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());

		const Eigen::Matrix3Xd coordinates = Eigen::Matrix3d::Identity().replicate(1, assembly.placeCount());
		ASSERT_TRUE(inCoordinates.factorize(jacobian.matrix(), coordinates, metric.matrix(), 0.3));
		const SparseMatrix& all = inCoordinates.lower();
		const Positions move = Positions::Random(3, assembly.placeCount());
		const Eigen::VectorXd product = all.selfadjointView<Eigen::Lower>() * move.reshaped();
		const Eigen::VectorXd image =
			(jacobian.applyTransposed(jacobian.apply(move)) + 0.3 * metric.apply(move)).reshaped();
		EXPECT_LT((product - image).norm(), 1e-13 * image.norm());
	}
}

TEST(NormalSteps, TakeAwayCurvatureOfShortWaves) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(25, 25, quarterCylinder), 0.02));
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 100, silent);
	EXPECT_EQ(detail::NormalSteps(problem, run, 1).run(), detail::Ending::Reached);
	EXPECT_LE(run.shape().curvature, 1e-4);
	EXPECT_LE(angleDefects(assembly, run.shape().positions).cwiseAbs().sum(), 1e-4);
	EXPECT_LT(meanDisplacement(assembly, run.shape().positions), 0.002);
	expectSound(assembly, run.shape().positions);
}

/// With as many as it takes they get there; with one fewer they are stuck, and the run may go on.
TEST(NormalSteps, TakeNoMoreThanTheyMay) {
	const PatchAssembly assembly = assembled(noisy(jitteredGrid(25, 25, quarterCylinder), 0.02));
	const Progress silent;
	const auto endingWith = [&](int most) {
		detail::NewtonProblem problem = problemOf(assembly);
		detail::NewtonRun run(problem, assembly.originalPositions, 100, silent);
		detail::NormalSteps steps(problem, run, 1);
		steps.takeAtMost(most);
		const detail::Ending ending = steps.run();
		return std::make_pair(ending, run.iterations());
	};
	const auto [ending, taken] = endingWith(100);
	ASSERT_EQ(ending, detail::Ending::Reached);
	ASSERT_GT(taken, 1);
	EXPECT_EQ(endingWith(taken), std::make_pair(detail::Ending::Reached, taken));
	EXPECT_EQ(endingWith(taken - 1), std::make_pair(detail::Ending::Stuck, taken - 1));
}

TEST(NormalSteps, EndAtTheirLimitsAndWhenAskedTo) {
	const PatchAssembly assembly = assembled(jitteredGrid(15, 15, largeSaddle));
	detail::NewtonProblem problem = problemOf(assembly);
	const auto endingWith = [&](int steps, const Progress& progress, double farthest) {
		detail::NewtonRun run(problem, assembly.originalPositions, steps, progress);
		const detail::Ending ending = detail::NormalSteps(problem, run, farthest).run();
		EXPECT_LE(run.iterations(), steps);
		EXPECT_LE(run.shape().farthest, farthest);
		return ending;
	};
	EXPECT_EQ(endingWith(2, {}, 1), detail::Ending::OutOfSteps);
	EXPECT_EQ(endingWith(100, {}, 1e-6), detail::Ending::Stuck); // it may hardly move
	EXPECT_EQ(endingWith(
				  100, [](double, const std::string&) { return false; }, 1),
			  detail::Ending::Stopped);
}

} // namespace
} // namespace developable::test
