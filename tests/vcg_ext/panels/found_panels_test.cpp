// SPDX-License-Identifier: GPL-3.0-or-later
// Searches from clusters of several sizes: the best is found, and whoever asked is told from one thread only.
#include "developable/panels/found_panels.h"

#include "developable/panels/panel_plan.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>
#include <thread>

namespace developable::test {
namespace {

using detail::FoundPanels;
using detail::GivenPatches;
using detail::PanelPlan;

GivenPatches bump(int side) {
	return detail::separatePatches(jitteredGrid(side, side, steepBump), {});
}

std::vector<double> limitsOf(const GivenPatches& given) {
	return {0.02 * boxDiagonal(given.mesh.positions)};
}

/// By one search alone.
int panelsFrom(const GivenPatches& given, double deviation) {
	PanelPlan plan({given, limitsOf(given), {}}, {});
	plan.cluster(deviation);
	plan.join();
	EXPECT_TRUE(plan.search()) << deviation;
	return plan.planned().surface.usedPanelCount();
}

TEST(FoundPanels, areAsFewAsThoseOfTheBestStart) {
	const GivenPatches patches = detail::separatePatches(sphere(1, 2), {});
	const FoundPanels found = detail::findPanels({patches, limitsOf(patches), {}}, {});
	ASSERT_TRUE(found.hold);
	int fewest = panelsFrom(patches, 0.15);
	for (const double deviation : {0.25, 0.35, 0.08})
		fewest = std::min(fewest, panelsFrom(patches, deviation));
	EXPECT_EQ(found.planned.front().surface.usedPanelCount(), fewest);
}

/// Of more triangles than panels are looked for on.
TEST(FoundPanels, ofAFineSurfaceAreThoseOfACoarseOne) {
	const auto panelsOf = [](int side) {
		const GivenPatches patches = detail::separatePatches(grid(side, side, bumpedCylinder), {});
		const FoundPanels found = detail::findPanels({patches, limitsOf(patches), {}}, {});
		EXPECT_TRUE(found.hold);
		EXPECT_GE(found.planned.front().mesh.triangleCount(), patches.mesh.triangleCount());
		return found.planned.front().surface.usedPanelCount();
	};
	EXPECT_LE(std::abs(panelsOf(66) - panelsOf(40)), 1);
}

TEST(FoundPanels, areToldOfFromTheThreadThatAsks) {
	const GivenPatches patches = bump(9);
	const std::thread::id asking = std::this_thread::get_id();
	bool fromHere = true;
	const FoundPanels found =
		detail::findPanels({patches, limitsOf(patches), {}}, [&](double, const std::string&) {
			fromHere = fromHere && std::this_thread::get_id() == asking;
			return true;
		});
	EXPECT_TRUE(found.hold);
	EXPECT_TRUE(fromHere);
}

TEST(FoundPanels, areNoneAfterAStopWhileStartsAreJoined) {
	const GivenPatches patches = bump(9);
	int calls = 0;
	const FoundPanels all =
		detail::findPanels({patches, limitsOf(patches), {}}, [&](double, const std::string&) {
			++calls;
			return true;
		});
	ASSERT_FALSE(all.stopped);
	for (const int limit : {1, calls / 4, calls / 2}) {
		int left = limit;
		const FoundPanels found = detail::findPanels({patches, limitsOf(patches), {}},
													 [&](double, const std::string&) { return left-- > 0; });
		EXPECT_TRUE(found.stopped) << limit << " of " << calls;
	}
}

} // namespace
} // namespace developable::test
