// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/refinement.h"

#include "developable/newton/coarsening.h"
#include "newton_problems.h"
#include "threads_allowed.h"

#include <atomic>

namespace developable::test {
namespace {

std::unique_ptr<detail::NewtonProblem> fineProblem(const PatchAssembly& assembly) {
	auto problem =
		std::make_unique<detail::NewtonProblem>(assembly, detail::CurvatureGoal(), NewtonTuning(), 0);
	problem->setSmoothness(3e-6);
	return problem;
}

TEST(Refinement, HasTheSameBitsBesideTheCoarseSolutionAndAfterIt) {
	const PatchAssembly assembly = assembled(jitteredGrid(51, 51, wave));
	Positions alone;
	for (const char* threads : {"1", "2"}) {
		const ThreadsAllowed allowed(threads);
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, {}, {}).status, Status::Converged);
		if (alone.cols() == 0)
			alone = positions;
		EXPECT_EQ(positions, alone);
	}
}

TEST(Refinement, IsNotMadeForNothingOnOneThread) {
	const PatchAssembly assembly = assembled(jitteredGrid(31, 31, wave));
	const PartialAssembly coarse = detail::Coarsening(assembly, {}).coarsen(300);
	for (const int threads : {1, 2}) {
		const ThreadsAllowed allowed(std::to_string(threads).c_str());
		std::atomic<int> made = 0;
		bool coarseSolved = false;
		detail::Refinement refinement(assembly, coarse, {}, 0, [&] {
			++made;
			return fineProblem(assembly);
		});
		refinement.prepareBeside([&] { coarseSolved = true; });
		EXPECT_TRUE(coarseSolved);
		EXPECT_EQ(made, std::min(threads, availableThreads()) - 1);
		const Positions still = refinement.prolonged(Positions::Zero(3, coarse.assembly.placeCount()));
		EXPECT_EQ(still, Positions::Zero(3, assembly.placeCount()));
		EXPECT_EQ(&refinement.problem().assembly(), &assembly);
		EXPECT_EQ(made, 1);
	}
}

TEST(Refinement, EndsWithWhatTheCoarseSolutionThrows) {
	const PatchAssembly assembly = assembled(jitteredGrid(31, 31, wave));
	const PartialAssembly coarse = detail::Coarsening(assembly, {}).coarsen(300);
	detail::Refinement refinement(assembly, coarse, {}, 0, [&] { return fineProblem(assembly); });
	EXPECT_THROW(refinement.prepareBeside([] { throw std::bad_alloc(); }), std::bad_alloc);
}

} // namespace
} // namespace developable::test
