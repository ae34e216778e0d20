// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/continuation.h"
#include "newton_problems.h"

namespace developable::test {
namespace {

TEST(Continuation, BringsASmoothShapeToNearlyNoCurvatureAndSettles) {
	const PatchAssembly assembly = assembled(jitteredGrid(21, 21, bumpedCylinder));
	detail::NewtonProblem problem = problemOf(assembly);
	problem.jacobian().freeBorders(true);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	detail::GaussNewton steps(problem, run, false);
	detail::Continuation continuation(problem, run, steps);
	const double first = continuation.epsilon();
	EXPECT_EQ(first, steps.greatestResponse() / 4);
	const detail::Ending ending = continuation.follow();
	EXPECT_TRUE(ending == detail::Ending::Settled || ending == detail::Ending::Reached);
	EXPECT_LT(run.shape().curvature, 0.03 * run.startCurvature());
	EXPECT_LT(continuation.epsilon(), first);
	expectSound(assembly, run.shape().positions);
}

/// What is far is in the way: without it the shape is farther on average, and nearer at most.
TEST(Continuation, KeepsFarPlacesNearWhereTheyAreHeavy) {
	const PatchAssembly assembly = sewnPatches(15);
	const Progress silent;
	const auto followed = [&](double share) {
		detail::NewtonProblem problem = problemOf(assembly);
		problem.jacobian().freeBorders(true);
		detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
		detail::GaussNewton steps(problem, run, false);
		detail::Continuation continuation(problem, run, steps);
		continuation.makeFarPlacesHeavy(share * problem.diagonal());
		continuation.follow();
		EXPECT_LT(run.shape().curvature, 0.03 * run.startCurvature());
		const Eigen::ArrayXd more = problem.metric().weight() - problem.metric().placeMass();
		EXPECT_GE(more.minCoeff(), 0);
		EXPECT_EQ(more.maxCoeff() > 0, share > 0);
		return std::pair(run.shape().farthest / problem.diagonal(),
						 problem.displacement(run.shape()).colwise().norm().mean() / problem.diagonal());
	};
	const auto [farthest, mean] = followed(0);
	const auto [nearer, meanOfNearer] = followed(0.7 * farthest);
	EXPECT_LT(nearer, 0.95 * farthest);
	EXPECT_GT(meanOfNearer, mean);
	EXPECT_LT(meanOfNearer, 1.3 * mean);
}

TEST(Continuation, FirstStepsLowerWhatTheyPromiseTo) {
	const PatchAssembly assembly = assembled(jitteredGrid(15, 15, wave));
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun run(problem, assembly.originalPositions, 200, silent);
	detail::GaussNewton steps(problem, run, false);
	const double epsilon = steps.greatestResponse() / 4;
	double last = steps.merit(run.shape(), epsilon);
	for (int i = 0; i < 4; ++i) {
		EXPECT_GT(steps.step(1, epsilon), 0);
		EXPECT_LT(steps.merit(run.shape(), epsilon), last);
		last = steps.merit(run.shape(), epsilon);
	}
}

TEST(Continuation, EndsAtItsLimitAndWhenAskedTo) {
	const PatchAssembly assembly = assembled(jitteredGrid(15, 15, wave));
	detail::NewtonProblem problem = problemOf(assembly);
	const Progress silent;
	detail::NewtonRun few(problem, assembly.originalPositions, 1, silent);
	detail::GaussNewton steps(problem, few, false);
	EXPECT_EQ(detail::Continuation(problem, few, steps).follow(), detail::Ending::OutOfSteps);
	const Progress stop = [](double, const std::string&) { return false; };
	detail::NewtonRun stopped(problem, assembly.originalPositions, 50, stop);
	detail::GaussNewton noSteps(problem, stopped, false);
	EXPECT_EQ(detail::Continuation(problem, stopped, noSteps).follow(), detail::Ending::Stopped);
	EXPECT_EQ(stopped.shape().positions, assembly.originalPositions);
}

} // namespace
} // namespace developable::test
