// SPDX-License-Identifier: GPL-3.0-or-later
// What is stuck goes on to less curvature, at fewer places.
#include "developable/newton/least_curvature.h"

#include "developable/newton/normal_steps.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

/// With dents and bumps all over: it can't become developable within a little, but the less curved.
TriangleMesh dentedDome() {
	return jitteredGrid(21, 21, [](double u, double v) -> Eigen::Vector3d {
		return sphereCap(1)(u, v) * (1 + 0.02 * std::sin(15 * u) * std::sin(13 * v));
	});
}

PatchAssembly dome() {
	return assembled(dentedDome());
}

double curvature(const PatchAssembly& assembly, const Positions& positions) {
	return angleDefects(assembly, positions).cwiseAbs().sum();
}

TEST(NormalStep, HasTheSlopeOfItsWeightedSquares) {
	const PatchAssembly assembly = dome();
	detail::NewtonProblem problem = problemOf(assembly);
	const detail::Shape shape = problem.shapeAt(assembly.originalPositions);
	const Eigen::VectorXd weights = Eigen::VectorXd::Constant(shape.scaledDefects.size(), 2) +
									Eigen::VectorXd::Random(shape.scaledDefects.size());
	double epsilon = 0;
	detail::NormalStep step(problem);
	ASSERT_TRUE(step.factorize(shape, weights, epsilon));
	EXPECT_GT(epsilon, 0);
	const auto halfSquares = [&](double length) {
		const Positions positions = assembly.originalPositions + length * step.whole();
		return problem.shapeAt(positions).scaledDefects.cwiseProduct(weights).squaredNorm() / 2;
	};
	constexpr double h = 1e-5;
	EXPECT_NEAR((halfSquares(h) - halfSquares(-h)) / (2 * h), step.slope(), 1e-4 * -step.slope());
	EXPECT_LT(halfSquares(1), halfSquares(0));
}

/// Of the same system without weights, to rounding.
TEST(NormalStep, DoesNotChangeWithEqualWeights) {
	const PatchAssembly assembly = dome();
	detail::NewtonProblem problem = problemOf(assembly);
	const detail::Shape shape = problem.shapeAt(assembly.originalPositions);
	const auto stepWith = [&](double weight) {
		detail::NormalStep step(problem);
		double epsilon = 0;
		EXPECT_TRUE(step.factorize(
			shape,
			weight == 0 ? Eigen::VectorXd() : Eigen::VectorXd::Constant(shape.scaledDefects.size(), weight),
			epsilon));
		return step.whole();
	};
	const Positions plain = stepWith(0);
	EXPECT_LT((stepWith(3) - plain).norm(), 1e-9 * plain.norm());
}

TEST(LeastCurvature, IsLessThanThatOfLeastSquaresAndAtFewerPlaces) {
	const PatchAssembly assembly = dome();
	const double farthest = 0.01 * boxDiagonal(assembly.originalPositions);
	detail::NewtonProblem problem(assembly, {1e-4, 1e-4, farthest}, {}, 0);
	problem.setSmoothness(3e-6);
	problem.jacobian().freeBorders(true);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 100, silent);
	ASSERT_EQ(detail::NormalSteps(problem, run, farthest).run(), detail::Ending::Stuck);
	const double before = run.shape().curvature;
	const Eigen::ArrayXd defectsBefore = angleDefects(assembly, run.shape().positions).cwiseAbs();
	detail::LeastCurvature(problem, run).run();
	const Eigen::ArrayXd defects = angleDefects(assembly, run.shape().positions).cwiseAbs();
	EXPECT_LT(run.shape().curvature, 0.95 * before);
	EXPECT_NEAR(run.shape().curvature, defects.sum(), 1e-9);
	constexpr double little = 1e-3;
	EXPECT_GT(double((defects < little).count()), 1.3 * double((defectsBefore < little).count()));
	EXPECT_LE(run.shape().farthest, farthest);
	expectSound(assembly, run.shape().positions);
}

TEST(LeastCurvature, EndsAtItsLimitsAndWhenAskedTo) {
	const PatchAssembly assembly = dome();
	detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.01}, {}, 0);
	problem.setSmoothness(3e-6);
	const auto endingWith = [&](int steps, const Progress& progress) {
		detail::NewtonRun run(problem, assembly.originalPositions, steps, progress);
		const detail::Ending ending = detail::LeastCurvature(problem, run).run();
		EXPECT_LE(run.iterations(), steps);
		return ending;
	};
	EXPECT_EQ(endingWith(2, {}), detail::Ending::OutOfSteps);
	EXPECT_EQ(endingWith(100, {}), detail::Ending::Stuck);
	EXPECT_EQ(endingWith(100, [](double, const std::string&) { return false; }), detail::Ending::Stopped);
}

ConstrainedNewtonReport solved(const PatchAssembly& assembly, int curvatureSteps, Positions& positions) {
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.01;
	options.tuning.curvatureSteps = curvatureSteps;
	positions = assembly.originalPositions;
	return constrainedNewton(assembly, positions, options);
}

TEST(LowerCurvature, GoesOnFromWhatNeedsACut) {
	const PatchAssembly assembly = dome();
	Positions without, with;
	const ConstrainedNewtonReport before = solved(assembly, 0, without);
	const ConstrainedNewtonReport report = solved(assembly, NewtonTuning().curvatureSteps, with);
	ASSERT_EQ(before.status, Status::NeedsCut);
	EXPECT_EQ(report.status, Status::NeedsCut);
	EXPECT_EQ(report.nearestDevelopable, before.nearestDevelopable);
	EXPECT_LT(curvature(assembly, with), 0.95 * curvature(assembly, without));
	EXPECT_GT(report.iterations, before.iterations);
	EXPECT_GT(report.work, before.work);
	EXPECT_LE((with - assembly.originalPositions).colwise().norm().maxCoeff(), 0.01);
	expectSound(assembly, with);
}

/// A sheet that is sewn to it keeps every bit, and its seam with it.
TEST(LowerCurvature, MovesNothingOfPanelsThatAreDevelopable) {
	const auto beside = [](double u, double v) -> Eigen::Vector3d {
		const Eigen::Vector3d rim = sphereCap(1)(1, v);
		return rim * (1 + 0.02 * std::sin(15) * std::sin(13 * v)) + Eigen::Vector3d(0.5 * u, 0, 0.3 * u);
	};
	const PatchAssembly assembly = assembled(together(dentedDome(), jitteredGrid(21, 21, beside)));
	ASSERT_EQ(assembly.patchCount(), 2);
	Positions without, with;
	solved(assembly, 0, without);
	const ConstrainedNewtonReport report = solved(assembly, NewtonTuning().curvatureSteps, with);
	ASSERT_EQ(report.patchesNeedingCut, 1);
	EXPECT_EQ(report.patchVerdicts[0].status, Status::NeedsCut);
	EXPECT_EQ(report.patchVerdicts[1].status, Status::Converged);
	EXPECT_LT(curvature(assembly, with), curvature(assembly, without));
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int place = assembly.placeOfCopy[copy];
		EXPECT_TRUE(assembly.patchOfCopy[copy] == 0 || with.col(place) == without.col(place));
	}
}

/// With places that are held the least squares of g are what is looked for.
TEST(LowerCurvature, LeavesWhatHoldsPlacesAsItIs) {
	PatchAssembly assembly = dome();
	assembly.placeFixed.front() = 1;
	Positions without, with;
	solved(assembly, 0, without);
	EXPECT_EQ(solved(assembly, NewtonTuning().curvatureSteps, with).status, Status::Stalled);
	EXPECT_EQ(with, without);
}

TEST(LowerCurvature, StopsWhenItIsTold) {
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.01;
	expectStopsAt("what is left: ", dome(), options);
}

} // namespace
} // namespace developable::test
