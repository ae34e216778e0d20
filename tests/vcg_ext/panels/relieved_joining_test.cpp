// SPDX-License-Identifier: GPL-3.0-or-later
// Halves of a cap that is too round for one panel are one with darts.
#include "developable/panels/panel_joining.h"
#include "developable/panels/panel_test.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::JoinHistory;
using detail::joinWithRelief;
using detail::PanelTests;

TEST(RelievedJoining, aCapBecomesOnePanelWithDarts) {
	const TriangleMesh mesh = grid(19, 19, sphereCap(1));
	CutSurface surface = withPanels(mesh, strips(mesh, 2));
	const double before = seamLength(surface);
	double whole = 0; // how far a half moves by itself, and the whole, which is farther
	PanelTests unbounded({100}, {}, {});
	std::vector<int> all(mesh.triangleCount());
	std::iota(all.begin(), all.end(), 0);
	whole = unbounded.test({{CutSurface(assembled(mesh)).meshOf(all), 0}}).front().maxDisplacement;
	const double half = unbounded.test({{surface.meshOf(surface.trianglesOf(surface.panelOf(0))), 0}})
							.front()
							.maxDisplacement;
	ASSERT_LT(half, 0.6 * whole);
	const double limit = 0.7 * whole / 0.75; // alone a panel has three quarters of it
	PanelTests tests({limit}, {}, {});
	JoinHistory history;
	std::vector<Eigen::Vector3d> tips;
	joinPanels(surface, tests, history);
	ASSERT_EQ(surface.usedPanelCount(), 2);
	joinWithRelief(surface, tests, history, tips);
	EXPECT_EQ(surface.usedPanelCount(), 1);
	EXPECT_GE(tips.size(), 1U);
	EXPECT_LT(seamLength(surface), before);
	EXPECT_TRUE(testPanel(surface.meshOf(all), tests.limitsOf(0)).flat);
}

TEST(RelievedJoining, noDartIsCutWhereNoneIsNeededOrNoneHelps) {
	const TriangleMesh flat = grid(9, 9, flatSheet);
	CutSurface surface = withPanels(flat, strips(flat, 2));
	JoinHistory history;
	std::vector<Eigen::Vector3d> tips;
	PanelTests tests({1}, {}, {});
	joinWithRelief(surface, tests, history, tips);
	EXPECT_EQ(surface.usedPanelCount(), 1);
	EXPECT_TRUE(tips.empty());

	const TriangleMesh round = grid(9, 9, sphereCap(1));
	surface = withPanels(round, strips(round, 2));
	const auto before = panelsOf(surface);
	PanelTests strict({1e-4}, {}, {});
	joinWithRelief(surface, strict, history, tips);
	EXPECT_EQ(panelsOf(surface), before);
	EXPECT_TRUE(tips.empty());
}

} // namespace
} // namespace developable::test
