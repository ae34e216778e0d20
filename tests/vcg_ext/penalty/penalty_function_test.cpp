// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/penalty/penalty_function.h"

#include "developable/geometry/geometry.h"
#include "support/finite_differences.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

double detectFunctionAt(const PatchAssembly& assembly, const Positions& positions) {
	return detectFunction(angleDefects(assembly, positions));
}

TEST(PenaltyFunction, GradientOfThePenaltyFunctionAgreesWithCentralDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(7, 7, bumpedCylinder));
	detail::PenaltyFunction function(assembly);
	function.weighFor(detectFunctionAt(assembly, assembly.originalPositions));
	const Positions at = jitteredGrid(7, 7, bumpedCylinder, 0.3).positions;
	const Positions differences =
		centralDifferences([&](const Positions& p) { return function.value(p); }, at);
	EXPECT_LT((function.gradient(at) - differences).norm(), 1e-6 * differences.norm());
}

TEST(PenaltyFunction, StartsWithThePenaltyOfThePaper) {
	// With ρ = Σ l0² / (n_e G²) and E = 0 the start has J = half of the mean squared edge length.
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	detail::PenaltyFunction function(assembly);
	function.weighFor(detectFunctionAt(assembly, assembly.originalPositions));
	const double meanSquare =
		edgeLengths(assembly, assembly.originalPositions).squaredNorm() / assembly.edgeCount();
	EXPECT_NEAR(function.value(assembly.originalPositions), meanSquare / 2, 1e-12 * meanSquare);
}

} // namespace
} // namespace developable::test
