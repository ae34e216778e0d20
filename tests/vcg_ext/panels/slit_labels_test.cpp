// SPDX-License-Identifier: GPL-3.0-or-later
// Slits are found again on another surface, and a panel that has one stays one panel.
#include "developable/panels/slit_labels.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::SlitLabels;

/// The unit square in one panel, its two halves joined along a share of the line between them only.
CutSurface withSlit(const TriangleMesh& mesh, const std::vector<int>& halves, double open) {
	CutSurface surface = withPanels(mesh, halves);
	std::vector<int> joined;
	const std::vector<detail::SeamChain> chains = detail::seamChains(surface);
	for (const int h : chains.front().halfEdges)
		if (surface.middleOf(h)[1] < open)
			joined.push_back(h);
	surface.join(joined);
	return surface;
}

TEST(SlitLabels, aPanelStaysOneHoweverLongItsSlitIs) {
	const TriangleMesh mesh = grid(21, 21, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const std::vector<int> halves = strips(mesh, 2);
	for (const double open : {0.8, 0.2}) {
		const CutSurface surface = withSlit(mesh, halves, open);
		ASSERT_EQ(surface.usedPanelCount(), 1);
		const SlitLabels labels(surface, halves);
		EXPECT_EQ(labels.count(), 2);
		CutSurface other = withPanels(mesh, halves);
		labels.openWithin(other, labels.labels());
		EXPECT_EQ(other.usedPanelCount(), 1);
		EXPECT_NEAR(seamLength(other), seamLength(surface), 1e-9); // as long as it was
	}
}

TEST(SlitLabels, panelsThatWereTwoStayTwo) {
	const TriangleMesh mesh = grid(21, 21, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const CutSurface surface = withPanels(mesh, strips(mesh, 2));
	const SlitLabels labels(surface, strips(mesh, 4));
	EXPECT_EQ(labels.count(), 2);
	CutSurface other = withPanels(mesh, labels.labels());
	labels.openWithin(other, labels.labels());
	EXPECT_EQ(other.usedPanelCount(), 2);
}

/// Round a tube, from one angle to another, shares of a turn.
std::vector<int> sector(const TriangleMesh& mesh, double from, double to) {
	return labelsOf(mesh, [&](const Eigen::Vector3d& at) {
		const double turn = std::atan2(at[1], at[0]) / (2 * pi);
		return turn > from && turn < to;
	});
}

/// Both seams between the two clusters run near where the tube was whole then.
TEST(SlitLabels, aTubeWithASlitKeepsOne) {
	const TriangleMesh mesh = tube(60, 9);
	const std::vector<int> clusters = sector(mesh, 0, 0.25);
	CutSurface surface = withPanels(mesh, clusters);
	for (const detail::SeamChain& chain : detail::seamChains(surface))
		if (surface.middleOf(chain.halfEdges.front())[1] < 0.5)
			surface.join(chain.halfEdges);
	ASSERT_EQ(surface.usedPanelCount(), 1);
	const SlitLabels labels(surface, clusters);
	CutSurface other = withPanels(mesh, sector(mesh, -0.1, 0.1));
	labels.openWithin(other, sector(mesh, -0.1, 0.1));
	ASSERT_EQ(other.usedPanelCount(), 1);
	EXPECT_EQ(detail::eulerCharacteristic(other, other.panelOf(0)), 1);
	EXPECT_NEAR(seamLength(other), 2, 1e-9); // the tube is so long
}

TEST(SlitLabels, aPanelWhoseTwoEndsMeetGetsASlit) {
	const TriangleMesh mesh = tube(60, 9);
	const std::vector<int> whole = sector(mesh, 0, 0.1); // between the ends, all along the tube
	std::vector<int> half = whole;
	for (int t = 0; t < mesh.triangleCount(); ++t)
		half[t] = whole[t] && mesh.positions(2, mesh.triangles(0, t)) < 1;
	const CutSurface surface = withPanels(mesh, whole);
	const SlitLabels labels(surface, whole);
	CutSurface other = withPanels(mesh, half);
	ASSERT_EQ(detail::eulerCharacteristic(other, other.panelOf(mesh.triangleCount() - 1)), 0);
	labels.openWithin(other, half);
	EXPECT_EQ(other.usedPanelCount(), 2);
	for (const int triangle : {0, mesh.triangleCount() - 1})
		EXPECT_EQ(detail::eulerCharacteristic(other, other.panelOf(triangle)), 1);
}

/// Where two clusters meet along two seams with a third one between these, one seam may go after the other.
TEST(SlitLabels, seamsRoundAClusterOpenOneAfterTheOther) {
	const TriangleMesh mesh = grid(31, 31, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	const std::vector<int> clusters = labelsOf(mesh, [](const Eigen::Vector3d& at) {
		const bool inside = std::max(std::abs(at[0] - 0.5), std::abs(at[1] - 0.5)) < 0.2;
		return inside ? 2 : at[1] > 0.5 ? 1 : 0;
	});
	CutSurface surface = withPanels(mesh, clusters);
	for (const detail::SeamChain& chain : detail::seamChains(surface)) {
		std::vector<int> open; // all but a dart
		for (const int h : chain.halfEdges)
			if (surface.middleOf(h)[0] < 0.9)
				open.push_back(h);
		surface.join(open);
	}
	ASSERT_EQ(surface.usedPanelCount(), 1);
	const SlitLabels labels(surface, clusters);
	ASSERT_EQ(labels.count(), 3);
	CutSurface other = withPanels(mesh, clusters);
	labels.openWithin(other, labels.labels());
	EXPECT_EQ(other.usedPanelCount(), 1);
	EXPECT_NEAR(seamLength(other), 0.1, 1e-9);
}

} // namespace
} // namespace developable::test
