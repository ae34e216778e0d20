// SPDX-License-Identifier: GPL-3.0-or-later
// What a processor with narrower registers makes of the same shapes. A child process of each test takes AVX2
// from what the compiler's run-time library says of the processor, before anything has asked for it.
#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/local/local_method.h"
#include "developable/newton/constrained_newton.h"
#include "developable/penalty/penalty_method.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__x86_64__) && defined(__GNUC__)

/// As GCC's and Clang's run-time libraries have it; what __builtin_cpu_supports reads.
struct ProcessorModel {
	unsigned vendor, type, subtype, features;
};
extern ProcessorModel processorModel __asm__("__cpu_model"); // theirs: NOLINT(bugprone-reserved-identifier)

namespace developable::test {
namespace {

constexpr unsigned avx2 = 1U << 10U;

struct Outcome {
	bool wide;  ///< the child saw AVX2
	int status; ///< of Status
	int count;  ///< of the numbers
	double numbers[3000];
};

void note(Outcome& outcome, Status status, const Eigen::MatrixXd& numbers) {
	outcome.status = static_cast<int>(status);
	outcome.count = static_cast<int>(numbers.size());
	ASSERT_LE(outcome.count, 3000);
	std::copy(numbers.data(), numbers.data() + numbers.size(), outcome.numbers);
}

using Run = void (*)(const PatchAssembly& assembly, Outcome& outcome);

Outcome inChild(Run run, const TriangleMesh& mesh, bool withAvx2) {
	void* shared = mmap(nullptr, sizeof(Outcome), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	auto* outcome = new (shared) Outcome{};
	outcome->status = -1;
	const pid_t child = fork();
	if (child == 0) {
		if (!withAvx2)
			processorModel.features &= ~avx2;
		outcome->wide = __builtin_cpu_supports("avx2");
		run(assembled(mesh), *outcome);
		_exit(0);
	}
	int ending = 0;
	EXPECT_EQ(waitpid(child, &ending, 0), child);
	EXPECT_TRUE(WIFEXITED(ending) && WEXITSTATUS(ending) == 0);
	const Outcome result = *outcome;
	munmap(shared, sizeof(Outcome));
	return result;
}

/// The run with AVX2 and the one without, having made sure that they are.
std::pair<Outcome, Outcome> onBoth(Run run, const TriangleMesh& mesh) {
	const Outcome wide = inChild(run, mesh, true), narrow = inChild(run, mesh, false);
	EXPECT_TRUE(wide.wide);
	EXPECT_FALSE(narrow.wide);
	EXPECT_EQ(wide.status, narrow.status);
	EXPECT_EQ(wide.count, narrow.count);
	EXPECT_GT(wide.count, 0);
	return {wide, narrow};
}

void expectSameBits(Run run) {
	if (!__builtin_cpu_supports("avx2"))
		GTEST_SKIP() << "this processor has no AVX2";
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(largeSaddle), sphereCap(1)}) {
		const auto [wide, narrow] = onBoth(run, jitteredGrid(13, 17, surface));
		for (int i = 0; i < wide.count; ++i)
			ASSERT_EQ(wide.numbers[i], narrow.numbers[i]) << i;
	}
}

/// \param nearness  of sheets of length 1
// A saddle has several equally near developable shapes, of which the last bits choose: it is not among these.
void expectSameVerdict(Run run, double nearness) {
	if (!__builtin_cpu_supports("avx2"))
		GTEST_SKIP() << "this processor has no AVX2";
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(vamp), Surface(wave)}) {
		const auto [wide, narrow] = onBoth(run, jitteredGrid(13, 17, surface));
		for (int i = 0; i < wide.count; ++i)
			ASSERT_NEAR(wide.numbers[i], narrow.numbers[i], nearness) << i;
	}
}

TEST(WithoutAvx2, MeasuresHaveTheSameBits) {
	expectSameBits([](const PatchAssembly& assembly, Outcome& outcome) {
		note(outcome, Status::Converged, angleDefects(assembly, assembly.originalPositions));
	});
}

TEST(WithoutAvx2, ThePenaltyMethodHasTheSameBits) {
	expectSameBits([](const PatchAssembly& assembly, Outcome& outcome) {
		Positions positions = assembly.originalPositions;
		PenaltyMethodOptions options;
		options.maxIterations = 20;
		const Status status = penaltyMethod(assembly, positions, options).status;
		note(outcome, status, positions);
	});
}

TEST(WithoutAvx2, TheLocalMethodHasTheSameBits) {
	expectSameBits([](const PatchAssembly& assembly, Outcome& outcome) {
		Positions positions = assembly.originalPositions;
		LocalMethodOptions options;
		options.maxOperations = 3000;
		const Status status = localMethod(assembly, positions, options).status;
		note(outcome, status, positions);
	});
}

TEST(WithoutAvx2, TheConstrainedNewtonMethodHasTheSameVerdictAndMovesAsFar) {
	expectSameVerdict(
		[](const PatchAssembly& assembly, Outcome& outcome) {
			Positions positions = assembly.originalPositions;
			const Status status = constrainedNewton(assembly, positions, ConstrainedNewtonOptions()).status;
			note(outcome, status,
				 Eigen::MatrixXd::Constant(1, 1,
										   displacementMap(assembly.originalPositions, positions).mean()));
		},
		5e-4);
}

TEST(WithoutAvx2, PatternsAreTheSame) {
	expectSameVerdict(
		[](const PatchAssembly& assembly, Outcome& outcome) {
			const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
			note(outcome, Status::Converged, patterns.positions);
		},
		1e-5);
}

} // namespace
} // namespace developable::test

#endif
