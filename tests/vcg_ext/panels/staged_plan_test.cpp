// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that get more room from stage to stage, and how many fail when they are first sewn together.
#include "developable/panels/panel_plan.h"

#include "developable/panels/sewn_failures.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CarriedPanels;
using detail::GivenPatches;
using detail::PanelPlan;
using detail::PlannedSurface;

PanelPlan planOf(const GivenPatches& given, const Progress& progress = {}, bool confirmed = true) {
	return {{given, {0.02 * boxDiagonal(given.mesh.positions)}, {}, confirmed}, progress};
}

TEST(StagedPlan, hasNoMorePanelsFromStageToStage) {
	const GivenPatches given = detail::separatePatches(sphere(1, 3), {});
	PanelPlan plan = planOf(given);
	plan.cluster(0.15);
	ASSERT_TRUE(plan.searchInStages());
	EXPECT_EQ(plan.result().report.status, Status::Converged);
	EXPECT_FALSE(plan.sewn().provisional);
	const std::vector<PlannedSurface> found = plan.found();
	ASSERT_GT(found.size(), 1u);
	for (std::size_t i = 1; i < found.size(); ++i)
		EXPECT_GE(found[i].surface.usedPanelCount(), found[i - 1].surface.usedPanelCount()) << i;
	EXPECT_GT(found.back().surface.usedPanelCount(), found.front().surface.usedPanelCount());
}

TEST(StagedPlan, endsWithBriefRunsWhereNothingIsConfirmed) {
	const GivenPatches given = detail::separatePatches(grid(50, 50, bumpedCylinder), {});
	for (const bool confirmed : {true, false}) {
		PanelPlan plan = planOf(given, {}, confirmed);
		plan.cluster(0.15);
		EXPECT_TRUE(plan.searchInStages());
		EXPECT_EQ(plan.sewn().provisional, !confirmed);
	}
}

TEST(StagedPlan, findsNothingAfterAStop) {
	const GivenPatches given = detail::separatePatches(sphere(1, 2), {});
	int calls = 0;
	PanelPlan whole = planOf(given, [&](double, const std::string&) { return ++calls > 0; });
	whole.cluster(0.15);
	ASSERT_TRUE(whole.searchInStages());
	int left = calls / 2;
	PanelPlan stopped = planOf(given, [&](double, const std::string&) { return left-- > 0; });
	stopped.cluster(0.15);
	EXPECT_FALSE(stopped.searchInStages());
	EXPECT_TRUE(stopped.stopped());
	EXPECT_EQ(stopped.result().report.status, Status::Stopped);
}

/// A steep bump in strips: one holds no more than a whole bump does, narrow ones all do.
TEST(StagedPlan, knowsHowManyFailAtFirst) {
	const GivenPatches given = detail::separatePatches(jitteredGrid(21, 21, steepBump), {});
	PanelPlan plan = planOf(given);
	const auto failuresOf = [&](int count) {
		const std::vector<int> labels = strips(given.mesh, count);
		plan.takeOver(CarriedPanels{{given.mesh, given.origins, withPanels(given.mesh, labels)}, labels});
		return worstFirst(plan.sewnAtFirst()).size();
	};
	EXPECT_EQ(failuresOf(1), 1u);
	EXPECT_EQ(failuresOf(9), 0u);
	EXPECT_EQ(plan.planned().surface.usedPanelCount(), 9); // as they were
}

} // namespace
} // namespace developable::test
