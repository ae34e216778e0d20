// SPDX-License-Identifier: GPL-3.0-or-later
// The two sides of every slit and dart have different labels.
#include "developable/panels/cut_sides.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace developable::test {
namespace {

using detail::CutSurface;

/// \return the number of labels
int expectSidesApart(const CutSurface& surface) {
	const std::vector<int> labels = detail::cutSides(surface);
	const PatchAssembly& assembly = surface.assembly();
	std::vector<int> panelOfLabel(1 + *std::max_element(labels.begin(), labels.end()), -1);
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		int& panel = panelOfLabel[labels[triangleOf(h)]];
		EXPECT_TRUE(panel < 0 || panel == surface.panelOf(triangleOf(h)));
		panel = surface.panelOf(triangleOf(h));
		if (surface.isCut(h)) {
			EXPECT_NE(labels[triangleOf(h)], labels[triangleOf(assembly.across(h))]) << h;
		}
	}
	return static_cast<int>(panelOfLabel.size());
}

/// Cuts every edge within a square whose middle is on some lines.
void cutAlong(CutSurface& surface, const std::function<bool(const Eigen::Vector3d&)>& isOnLine) {
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h)
		if (surface.assembly().across(h) >= 0 && isOnLine(surface.middleOf(h)))
			surface.setCut(h, true);
}

bool isNear(double a, double b) {
	return std::abs(a - b) < 1e-9;
}

TEST(CutSides, AreOneWhereNothingIsCut) {
	EXPECT_EQ(expectSidesApart(square()), 1);
	const TriangleMesh mesh = grid(9, 9, flatSheet);
	EXPECT_EQ(expectSidesApart(withPanels(mesh, strips(mesh, 3))), 3);
}

TEST(CutSides, AreTwoAtADart) {
	CutSurface surface = square();
	cutAlong(surface, [](const Eigen::Vector3d& at) { return isNear(at[0], 0.5) && at[1] < 0.6; });
	ASSERT_EQ(surface.usedPanelCount(), 1);
	EXPECT_EQ(expectSidesApart(surface), 2);
	const std::vector<int> labels = detail::cutSides(surface);
	for (int t = 0; t < surface.assembly().triangleCount(); ++t) // behind the tip, too
		EXPECT_EQ(labels[t] == labels[0], surface.barycentre(t)[0] < 0.5) << t;
}

/// A cross within the square, whose arms meet at a vertex with as few as one triangle between two of them.
TEST(CutSides, DifferRoundAJunction) {
	CutSurface surface = square();
	cutAlong(surface, [](const Eigen::Vector3d& at) {
		const bool across = isNear(at[1], 0.5) && at[0] > 0.2 && at[0] < 0.8;
		const bool down = isNear(at[0], 0.5) && at[1] > 0.2 && at[1] < 0.8;
		const double sum = at[0] + at[1], difference = at[0] - at[1];
		return across || down || ((isNear(sum, 1) || isNear(difference, 0)) && at[0] > 0.4 && at[0] < 0.6);
	});
	ASSERT_EQ(surface.usedPanelCount(), 1);
	EXPECT_GT(expectSidesApart(surface), 4);
}

} // namespace
} // namespace developable::test
