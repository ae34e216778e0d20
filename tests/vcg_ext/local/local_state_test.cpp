// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local/local_state.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

TEST(LocalState, DerivativeOfTAgreesWithDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(7, 7, bumpedCylinder));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	const double step = 1e-6;
	for (int place = 0; place < assembly.placeCount(); ++place) {
		if (!state.mesh().movable(place))
			continue;
		const double derivative = state.localDerivative(place);
		state.moveTo(place, step);
		const double above = state.localDetectFunction(place);
		state.moveTo(place, -step);
		const double below = state.localDetectFunction(place);
		state.moveTo(place, 0);
		EXPECT_NEAR(derivative, (above - below) / (2 * step), 1e-6 * std::max(1.0, std::abs(derivative)));
	}
}

TEST(LocalState, DerivativeOfTheUnevennessAgreesWithDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 6, bumpedCylinder));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (state.mesh().movable(place))
			state.moveTo(place, 0.01 * (place % 7 - 3));
	const auto& order = state.mesh().originalPlace;
	const int place = static_cast<int>(std::find(order.begin(), order.end(), 14) - order.begin());
	const double height = state.height(place), derivative = state.unevennessDerivative(place);
	state.moveTo(place, height + 1e-5);
	const double above = state.unevenness(place);
	state.moveTo(place, height - 1e-5);
	EXPECT_NEAR(derivative, (above - state.unevenness(place)) / 2e-5, 1e-9);
	EXPECT_GT(std::abs(derivative), 1e-3);
}

TEST(LocalState, KeepsAngleDefectsEqualToANewComputation) {
	const PatchAssembly assembly = assembled(jitteredGrid(8, 8, saddle));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	for (int place = 0; place < assembly.placeCount(); place += 3)
		if (state.mesh().movable(place))
			state.moveTo(place, 0.01 * (place % 5 - 2));
	EXPECT_EQ(state.defects(), angleDefects(assembly, state.positions()));
	EXPECT_NEAR(state.detectFunction(), detectFunction(state.defects()), 1e-12);
}

} // namespace
} // namespace developable::test
