// SPDX-License-Identifier: GPL-3.0-or-later
// What does not hold falls apart again, and nothing else does.
#include "developable/panels/taken_back_joins.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::JoinHistory;
using detail::PlannedSurface;
using detail::seamChains;

/// Across the seam whose middle is nearest to some x.
void joinAt(CutSurface& surface, JoinHistory& history, double x) {
	for (const detail::SeamChain& chain : seamChains(surface))
		if (std::abs(surface.middleOf(chain.halfEdges.front())[0] - x) < 0.06)
			return history.join(surface, chain.halfEdges);
}

CutSurface labelledSquare(const std::function<int(const Eigen::Vector3d&)>& label) {
	const TriangleMesh mesh = grid(21, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	return withPanels(mesh, labelsOf(mesh, label));
}

TEST(TakenBackJoins, areThoseOfFailingPanels) {
	CutSurface surface = labelledSquare([](const Eigen::Vector3d& point) { return int(4 * point[0]); });
	const std::set<std::vector<int>> four = panelsOf(surface);
	ASSERT_EQ(four.size(), 4U);
	JoinHistory history;
	joinAt(surface, history, 0.25);
	joinAt(surface, history, 0.75);
	const std::set<std::vector<int>> two = panelsOf(surface);
	ASSERT_EQ(two.size(), 2U);
	EXPECT_TRUE(takeBackLastJoins(surface, {surface.panelOf(0)}, history));
	EXPECT_EQ(surface.usedPanelCount(), 3);
	EXPECT_EQ(two.count(surface.trianglesOf(surface.panelOf(surface.assembly().triangleCount() - 1))), 1U);
	EXPECT_FALSE(takeBackLastJoins(surface, {surface.panelOf(0)}, history)); // it was never joined
}

TEST(TakenBackJoins, goOnToOneThatCanBeSeen) {
	CutSurface surface = labelledSquare([](const Eigen::Vector3d& point) {
		const bool tiny = point.head<2>().maxCoeff() < 0.07;
		return tiny ? 2 : point[0] > 0.5;
	});
	JoinHistory history;
	ASSERT_EQ(surface.usedPanelCount(), 3);
	joinAt(surface, history, 0.5);
	history.join(surface, seamChains(surface).front().halfEdges); // the tiny one last
	ASSERT_EQ(surface.usedPanelCount(), 1);
	EXPECT_TRUE(takeBackLastJoins(surface, {surface.panelOf(0)}, history));
	EXPECT_EQ(surface.usedPanelCount(), 3);
}

TEST(TakenBackJoins, divideOverlapsForGood) {
	CutSurface surface = labelledSquare([](const Eigen::Vector3d&) { return 0; });
	JoinHistory history;
	const int whole = surface.panelOf(0);
	ASSERT_TRUE(divideOverlapping(surface, {{whole, {{{0, 0.5, 0}, {1, 0.5, 0}}}}}, history));
	EXPECT_EQ(surface.usedPanelCount(), 2);
	EXPECT_TRUE(history.wasRefused(surface, seamChains(surface).front().halfEdges));
	EXPECT_FALSE(divideOverlapping(surface, {}, history));
}

TEST(TakenBackJoins, panelsBeforeAreThoseWithMostOfTheArea) {
	const TriangleMesh mesh = grid(21, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const auto planned = [&](double border) {
		return PlannedSurface{mesh, {}, withPanels(mesh, labelsOf(mesh, [=](const Eigen::Vector3d& at) {
													   return at[0] > border;
												   }))};
	};
	const PlannedSurface before = planned(0.5), now = planned(0.7);
	const int last = mesh.triangleCount() - 1;
	EXPECT_EQ(panelBefore(before, now, now.surface.panelOf(0)), before.surface.panelOf(0));
	EXPECT_EQ(panelBefore(before, now, now.surface.panelOf(last)), before.surface.panelOf(last));
}

} // namespace
} // namespace developable::test
