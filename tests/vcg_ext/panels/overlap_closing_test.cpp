// SPDX-License-Identifier: GPL-3.0-or-later
// Darts end sooner, corners of neighbours go, slits run at the other side; nothing falls apart.
#include "developable/panels/overlap_closing.h"

#include "developable/panels/sewn_failures.h"
#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::closeNotch;
using detail::closeOverlaps;
using detail::CutSurface;
using detail::seamLength;
using detail::SewnPanels;

/// Half edges of a panel that are cut, and whose middles are where they are wanted.
std::vector<int> cutsOf(const CutSurface& surface, int panel,
						const std::function<bool(const Eigen::Vector3d&)>& wanted) {
	std::vector<int> found;
	for (const int t : surface.trianglesOf(panel))
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (surface.isCut(h) && wanted(surface.middleOf(h)))
				found.push_back(h);
	return found;
}

/// A dart from the middle of the square's lower side to its centre, of four edges.
CutSurface withDart() {
	CutSurface surface = square();
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h) {
		const Eigen::Vector3d middle = surface.middleOf(h);
		if (std::abs(middle[0] - 0.5) < 1e-9 && std::abs(surface.vectorOf(h)[0]) < 1e-9 && middle[1] < 0.5)
			surface.setCut(h, true);
	}
	return surface;
}

TEST(OverlapClosing, dartsEndWhereTheyDoNotOverlap) {
	for (const double from : {0.25, 0.0}) {
		CutSurface surface = withDart();
		ASSERT_NEAR(seamLength(surface), 0.5, 1e-12);
		const int panel = surface.panelOf(0);
		const std::vector<int> notch =
			cutsOf(surface, panel, [&](const Eigen::Vector3d& at) { return at[1] > from; });
		EXPECT_TRUE(closeNotch(surface, panel, notch));
		EXPECT_NEAR(seamLength(surface), from, 1e-12);
		EXPECT_EQ(surface.usedPanelCount(), 1);
	}
}

/// Where sides cross at the mouth only, all up to there is closed from the tip on.
TEST(OverlapClosing, dartsAreClosedFromTheirTips) {
	CutSurface surface = withDart();
	const int panel = surface.panelOf(0);
	const std::vector<int> notch =
		cutsOf(surface, panel, [](const Eigen::Vector3d& at) { return at[1] > 0.125 && at[1] < 0.25; });
	EXPECT_TRUE(closeNotch(surface, panel, notch));
	EXPECT_NEAR(seamLength(surface), 0.125, 1e-12);
}

/// The lower right quarter is a neighbour; its corner at the centre is cut off.
TEST(OverlapClosing, cornersOfNeighboursGo) {
	const TriangleMesh mesh = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	CutSurface surface = withPanels(
		mesh, labelsOf(mesh, [](const Eigen::Vector3d& at) { return at[0] > 0.5 && at[1] < 0.5; }));
	const Eigen::Vector3d centre(0.5, 0.5, 0);
	const int panel = surface.panelOf(0);
	const double before = surface.area(panel);
	const std::vector<int> notch =
		cutsOf(surface, panel, [&](const Eigen::Vector3d& at) { return (at - centre).norm() < 0.1; });
	ASSERT_EQ(notch.size(), 2U);
	const std::vector<char> held(mesh.triangleCount(), 1);
	EXPECT_FALSE(closeNotch(surface, panel, notch, held));
	EXPECT_EQ(surface.area(panel), before);
	EXPECT_TRUE(closeNotch(surface, panel, notch));
	EXPECT_EQ(surface.usedPanelCount(), 2);
	const double after = surface.area(surface.panelOf(0));
	EXPECT_GT(after, before);
	EXPECT_LE(after, before + 1.0 / 64 + 1e-12); // a cell
}

TEST(OverlapClosing, leavesPanelsWhatTheyAre) {
	const TriangleMesh mesh = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	CutSurface surface = withPanels(
		mesh, labelsOf(mesh, [](const Eigen::Vector3d& at) { return at[0] > 0.875 && at[1] < 0.125; }));
	const std::set<std::vector<int>> before = panelsOf(surface);
	const int panel = surface.panelOf(0);
	const auto anywhere = [](const Eigen::Vector3d&) { return true; };
	EXPECT_FALSE(closeNotch(surface, panel, cutsOf(surface, panel, anywhere))); // all that the neighbour has
	EXPECT_EQ(panelsOf(surface), before);
	std::vector<int> border; // nothing is across
	for (int h = 0; h < 3 * surface.assembly().triangleCount() && border.size() < 3; ++h)
		if (surface.assembly().across(h) < 0 && surface.panelOf(triangleOf(h)) == panel)
			border.push_back(h);
	EXPECT_FALSE(closeNotch(surface, panel, border));
	EXPECT_EQ(panelsOf(surface), before);
}

/// A square ring with a slit that has a tooth.
TEST(OverlapClosing, slitsRunAtTheOtherSideOfATooth) {
	const TriangleMesh whole = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	TriangleMesh mesh = whole;
	std::vector<int> kept;
	for (int t = 0; t < whole.triangleCount(); ++t) {
		const Eigen::Vector3d at = whole.positions(Eigen::all, whole.triangles.col(t)).rowwise().mean();
		if ((at - Eigen::Vector3d(0.5, 0.5, 0)).cwiseAbs().maxCoeff() > 0.25)
			kept.push_back(t);
	}
	mesh.triangles = whole.triangles(Eigen::all, kept);
	mesh.face.resize(kept.size());
	mesh.triangleSelected.assign(kept.size(), 0);
	CutSurface surface = withPanels(mesh, std::vector<int>(kept.size(), 0));
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h) // up from the hole
		if (std::abs(surface.middleOf(h)[0] - 0.5) < 1e-9 && std::abs(surface.vectorOf(h)[0]) < 1e-9 &&
			surface.middleOf(h)[1] > 0.5)
			surface.setCut(h, true);
	const int panel = surface.panelOf(0);
	const std::vector<int> straight =
		cutsOf(surface, panel, [](const Eigen::Vector3d& at) { return at[1] > 0.75 && at[1] < 0.875; });
	ASSERT_EQ(straight.size(), 2U);
	const double length = seamLength(surface);
	ASSERT_TRUE(closeNotch(surface, panel, {straight[0], straight[0], straight[0]})); // round one triangle
	EXPECT_GT(seamLength(surface), length);
	const std::vector<int> tooth = cutsOf(surface, panel, [](const Eigen::Vector3d& at) {
		return at[1] > 0.75 - 1e-9 && at[1] < 0.875 + 1e-9;
	});
	ASSERT_EQ(tooth.size(), 4U);
	std::vector<int> oneSide; // two of one triangle
	for (const int h : tooth)
		for (const int other : tooth)
			if (h < other && triangleOf(h) == triangleOf(other))
				oneSide = {surface.assembly().across(h), surface.assembly().across(other)};
	ASSERT_EQ(oneSide.size(), 2U);
	EXPECT_TRUE(closeNotch(surface, panel, oneSide));
	EXPECT_NEAR(seamLength(surface), length, 1e-12);
	EXPECT_EQ(surface.usedPanelCount(), 1);
}

/// One panel with a dart that overlaps itself until the dart is as short as given.
SewnPanels overlappingFrom(const CutSurface& surface, double dart) {
	SewnPanels sewn;
	sewn.panels.resize(surface.panelCount());
	CutPanel& panel = sewn.panels[surface.panelOf(0)];
	panel.triangles = surface.assembly().triangleCount();
	panel.developable = seamLength(surface) <= dart + 1e-9;
	panel.reason = panel.developable ? Reason::AsStatus : Reason::NeedsCut;
	const double tip = seamLength(surface) - 0.125;
	if (!panel.developable)
		sewn.notches[surface.panelOf(0)] = {
			cutsOf(surface, surface.panelOf(0), [&](const Eigen::Vector3d& at) { return at[1] > tip; })};
	return sewn;
}

/// What is seen on the shape as it was takes no sewing; what comes to light after that does.
TEST(OverlapClosing, goesOnUntilNothingOverlaps) {
	for (const double seen : {0.25, 0.375, 1.0}) {
		CutSurface surface = withDart();
		int sewings = 0;
		const SewnPanels sewn = closeOverlaps(
			surface, {}, overlappingFrom(surface, 0.25),
			{[&] {
				 ++sewings;
				 return overlappingFrom(surface, 0.25);
			 },
			 [&](const SewnPanels&) { return overlappingFrom(surface, seen); }, [] { return true; }});
		EXPECT_EQ(worstOf(sewn), -1);
		EXPECT_EQ(sewings, seen < 0.3 ? 1 : 2);
		EXPECT_NEAR(seamLength(surface), 0.25, 1e-12);
	}
}

/// Of two notches that one dart has the second is closed with the first.
TEST(OverlapClosing, closesAllThatThereIs) {
	CutSurface surface = withDart();
	const int panel = surface.panelOf(0);
	SewnPanels sewn = overlappingFrom(surface, 0.25);
	const auto from = [&](double y) {
		return cutsOf(surface, panel,
					  [&](const Eigen::Vector3d& at) { return at[1] > y && at[1] < y + 0.125; });
	};
	sewn.notches[panel] = {from(0.25), from(0.375)};
	int sewings = 0;
	const detail::ClosingSteps steps{[&] {
										 ++sewings;
										 return overlappingFrom(surface, 0.25);
									 },
									 [&](const SewnPanels&) { return overlappingFrom(surface, 1); },
									 [] { return true; }};
	EXPECT_EQ(worstOf(closeOverlaps(surface, {}, sewn, steps)), -1);
	EXPECT_EQ(sewings, 1);
	EXPECT_NEAR(seamLength(surface), 0.25, 1e-12);
}

TEST(OverlapClosing, isNotForPanelsThatFailForOtherReasons) {
	CutSurface surface = withDart();
	SewnPanels failing = overlappingFrom(surface, 0.25);
	failing.notches.clear();
	const auto never = []() -> SewnPanels { throw std::logic_error("sewn for nothing"); };
	const detail::ClosingSteps steps{never, [&](const SewnPanels&) { return never(); }, [] { return true; }};
	EXPECT_GE(worstOf(closeOverlaps(surface, {}, failing, steps)), 0);
	EXPECT_NEAR(seamLength(surface), 0.5, 1e-12);
}

} // namespace
} // namespace developable::test
