// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/attempts.h"

#include "newton_problems.h"
#include "threads_allowed.h"

namespace developable::test {
namespace {

/// Of a sphere what is below a height, from its lower pole: the higher, the farther from developable.
TriangleMesh bowl(double height) {
	const TriangleMesh ball = sphere(1, 3);
	std::vector<int> kept;
	for (int t = 0; t < ball.triangleCount(); ++t)
		if (ball.positions(2, ball.triangles(0, t)) < height)
			kept.push_back(t);
	return makeMesh(ball.positions, ball.triangles(Eigen::all, kept));
}

/// \param workBeforeNext  a place, until the next attempt begins beside one
/// \param extra           share of the work for ways back
detail::NewtonOutcome attempted(const PatchAssembly& assembly, const char* threads, double workBeforeNext,
								double work, int maxIterations, double extra = 1) {
	const ThreadsAllowed allowed(threads);
	NewtonTuning tuning;
	tuning.workBeforeNext = workBeforeNext;
	detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.3}, tuning, 0);
	work *= assembly.placeCount();
	problem.setBudget(std::make_shared<detail::WorkBudget>(work, extra * work));
	return detail::attemptFrom(problem, assembly.originalPositions, 3e-6, maxIterations, {});
}

TEST(Attempts, EndTheSameWhenTheNextBeginsBesideOne) {
	constexpr double plenty = 1e9;
	const PatchAssembly assemblies[] = {assembled(jitteredGrid(15, 15, wave)), // the first attempt does
										assembled(noisy(jitteredGrid(11, 11, saddle), 0.02)),
										assembled(bowl(0)), assembled(bowl(0.9)), sewnPatches(9)};
	for (const PatchAssembly& assembly : assemblies)
		for (const auto& [work, maxIterations, extra] :
			 {std::tuple(plenty, 200, 1.0), std::tuple(plenty, 70, 1.0), std::tuple(2000.0, 200, 0.1)}) {
			const detail::NewtonOutcome alone = attempted(assembly, "1", 0, work, maxIterations, extra);
			for (const double before : {0.0, 100.0}) {
				const detail::NewtonOutcome beside =
					attempted(assembly, "2", before, work, maxIterations, extra);
				EXPECT_EQ(beside.positions, alone.positions);
				EXPECT_EQ(beside.ending, alone.ending);
				EXPECT_EQ(beside.iterations, alone.iterations);
				EXPECT_EQ(beside.nearestDevelopable, alone.nearestDevelopable);
				EXPECT_EQ(beside.bordersLimited, alone.bordersLimited);
			}
		}
}

double curvatureOf(const PatchAssembly& assembly, const Positions& positions) {
	return angleDefects(assembly, positions).cwiseAbs().sum();
}

TEST(Attempts, KeepTheLeastCurvedShapeOfAll) {
	for (const double height : {0.5, 0.9}) {
		const PatchAssembly assembly = assembled(bowl(height));
		const detail::NewtonOutcome best = attempted(assembly, "1", 0, 1e9, 200);
		EXPECT_EQ(best.ending, detail::Ending::Stuck);
		for (const bool careful : {true, false}) {
			detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.3}, {}, 0);
			const int steps = careful ? NewtonTuning().limitedSteps : 200;
			const detail::AttemptResult one =
				detail::attempt(problem, assembly.originalPositions, {3e-6, careful, steps}, {});
			EXPECT_LE(curvatureOf(assembly, best.positions), curvatureOf(assembly, one.positions));
		}
	}
}

TEST(Attempts, LeaveOutTheFreeOneWhereItWouldGoTheSameWay) {
	const auto stepsBeyondTheCareful = [&](double height, double borderTurn) {
		const PatchAssembly assembly = assembled(bowl(height));
		NewtonTuning tuning;
		tuning.borderTurn = borderTurn;
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.3}, tuning, 0);
		const Positions& start = assembly.originalPositions;
		const int all = detail::attemptFrom(problem, start, 3e-6, 1000, {}).iterations;
		return all - detail::attempt(problem, start, {3e-6, true, tuning.limitedSteps}, {}).iterations;
	};
	EXPECT_EQ(stepsBeyondTheCareful(0.5, 360), 0);
	EXPECT_GT(stepsBeyondTheCareful(0.5, 0.1), 0);
	EXPECT_GT(stepsBeyondTheCareful(1.2, 360), 0); // so much was left that triangles are made stiffer
}

/// Panels that are sewn together pull at each other; what has no neighbour goes its way as before.
TEST(Attempts, OfPanelsSewnTogetherStayWithinTheirPreferredMove) {
	const auto attemptWith = [](const PatchAssembly& assembly, double preferred, double farPlace) {
		NewtonTuning tuning;
		tuning.preferredMove = preferred;
		tuning.farPlace = farPlace;
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 100}, tuning, 0);
		const detail::AttemptResult result =
			detail::attempt(problem, assembly.originalPositions, {3e-6, false, 90}, {});
		EXPECT_EQ(result.ending, detail::Ending::Reached);
		EXPECT_LE(result.iterations, 90);
		return result.positions;
	};
	const auto farthest = [](const PatchAssembly& assembly, const Positions& positions) {
		return farthestMove(assembly, positions) / boxDiagonal(assembly.originalPositions);
	};
	const PatchAssembly together = sewnPatches(15), alone = assembled(jitteredGrid(15, 15, saddle));
	const double bound = 0.85 * farthest(together, attemptWith(together, 0, 5));
	EXPECT_LE(farthest(together, attemptWith(together, bound, 5)), bound);
	EXPECT_EQ(attemptWith(alone, bound, 5), attemptWith(alone, bound, 500));
}

/// Nothing of the work is kept for what does not come any more.
TEST(Attempts, ReleaseWhatIsKeptForTheNextOnceTheyAreThere) {
	for (const PatchAssembly& assembly : {sewnPatches(9), assembled(bowl(0.9))}) {
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.3}, {}, 0);
		problem.setBudget(std::make_shared<detail::WorkBudget>(1e9, 1e9));
		detail::WorkReserve reserve(problem.budget(), 0.5);
		const detail::AttemptResult result =
			detail::attempt(problem, assembly.originalPositions, {3e-6, true, 200, false, &reserve}, {});
		const bool reached = result.ending == detail::Ending::Reached;
		EXPECT_EQ(reached, assembly.patchCount() == 2);
		EXPECT_EQ(problem.budget().left() > 0.6e9, reached);
	}
}

TEST(Attempts, StopAtOnceThoughTheNextIsAtWork) {
	const PatchAssembly assembly = assembled(bowl(0.9));
	const ThreadsAllowed allowed("2");
	NewtonTuning tuning;
	tuning.workBeforeNext = 0;
	for (const int calls : {1, 30, 100}) {
		detail::NewtonProblem problem(assembly, {1e-4, 1e-4, 0.3}, tuning, 0);
		int left = calls;
		const detail::NewtonOutcome outcome =
			detail::attemptFrom(problem, assembly.originalPositions, 3e-6, 200,
								[&](double, const std::string&) { return --left > 0; });
		EXPECT_EQ(outcome.ending, detail::Ending::Stopped);
		EXPECT_EQ(left, 0);
	}
}

} // namespace
} // namespace developable::test
