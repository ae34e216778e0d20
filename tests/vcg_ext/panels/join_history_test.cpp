// SPDX-License-Identifier: GPL-3.0-or-later
// Joins that are taken back leave what was there before, and what stays apart is known.
#include "developable/panels/join_history.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::JoinHistory;
using detail::seamChains;

/// A sheet in three panels side by side.
CutSurface threeStrips() {
	const TriangleMesh mesh = grid(10, 4, flatSheet);
	return withPanels(mesh, strips(mesh, 3));
}

TEST(JoinHistory, takesBackTheLastJoinOfAPanelOnly) {
	CutSurface surface = threeStrips();
	const std::set<std::vector<int>> three = panelsOf(surface);
	ASSERT_EQ(three.size(), 3U);
	JoinHistory history;
	history.join(surface, seamChains(surface).front().halfEdges);
	const std::set<std::vector<int>> two = panelsOf(surface);
	history.join(surface, seamChains(surface).front().halfEdges);
	ASSERT_EQ(panelsOf(surface).size(), 1U);

	EXPECT_TRUE(history.takeBack(surface, surface.panelOf(0)));
	EXPECT_EQ(panelsOf(surface), two);
	const std::vector<int> seam = seamChains(surface).front().halfEdges;
	EXPECT_TRUE(history.wasRefused(surface, seam)); // the two are not joined again
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		history.takeBack(surface, panel);
	EXPECT_EQ(panelsOf(surface), three);
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		EXPECT_FALSE(history.takeBack(surface, panel)); // were never joined
}

TEST(JoinHistory, whatIsNeverAgainToBeIsNotJoined) {
	CutSurface surface = threeStrips();
	JoinHistory history;
	const std::vector<int> seam = seamChains(surface).front().halfEdges;
	CutSurface joined = surface;
	history.neverAgain(joined, joined.join(seam));
	EXPECT_TRUE(history.wasRefused(surface, seam));
	EXPECT_FALSE(history.wasRefused(surface, seamChains(surface).back().halfEdges));
}

TEST(JoinHistory, whatWasRefusedMayBeTriedWhenAPanelHasChanged) {
	CutSurface surface = threeStrips();
	JoinHistory history;
	const auto chains = seamChains(surface);
	ASSERT_EQ(chains.size(), 2U);
	history.refuse(surface, chains[0].halfEdges);
	EXPECT_TRUE(history.wasRefused(surface, chains[0].halfEdges));
	EXPECT_FALSE(history.wasRefused(surface, chains[1].halfEdges));
	history.join(surface, chains[1].halfEdges);
	EXPECT_FALSE(history.wasRefused(surface, chains[0].halfEdges));
	CutSurface other = threeStrips();
	history.tryAllAgain();
	EXPECT_FALSE(history.wasRefused(other, chains[0].halfEdges));
}

} // namespace
} // namespace developable::test
