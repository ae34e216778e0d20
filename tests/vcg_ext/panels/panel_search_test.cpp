// SPDX-License-Identifier: GPL-3.0-or-later
// How many searches there are.
#include "developable/panels/panel_search.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

/// 289 bumps and hollows of more than a radian each.
Eigen::Vector3d eggCrate(double u, double v) {
	return {u, v, 0.012 * std::sin(17 * pi * u) * std::sin(17 * pi * v)};
}

TEST(ClusterDeviations, areFewerWhereJoiningTakesLong) {
	const auto starts = [](const TriangleMesh& mesh, const CutOptions& options) {
		const detail::GivenPatches patches = detail::separatePatches(mesh, {});
		const std::vector<double> limits = {0.02 * boxDiagonal(patches.mesh.positions)};
		return detail::clusterDeviations({patches, limits, options}).size();
	};
	CutOptions leather;
	leather.material.bounds = StrainBounds::isotropic(0.05, 0.05);
	const TriangleMesh large = jitteredGrid(40, 40, saddle);
	EXPECT_EQ(starts(jitteredGrid(20, 20, saddle), {}), 4u);
	EXPECT_EQ(starts(large, {}), 3u);
	EXPECT_EQ(starts(large, leather), 1u);
	EXPECT_EQ(starts(jitteredGrid(70, 70, eggCrate), {}), 1u);
}

} // namespace
} // namespace developable::test
