// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a panel does not depend on how finely it is meshed.
#include "developable/panels/panel_test.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::PanelLimits;
using detail::PanelVerdict;

PanelVerdict verdictOn(const TriangleMesh& mesh, double maxDisplacement) {
	PanelLimits limits;
	limits.maxDisplacement = limits.meanDisplacement = maxDisplacement;
	return testPanel(mesh, limits);
}

TEST(PanelTest, ofManyPlacesSaysTheSameAsOfFew) {
	for (const Surface& surface : {sphereCap(1), sphereCap(0.6), Surface(saddle)}) {
		const TriangleMesh few = grid(19, 19, surface), many = grid(61, 61, surface);
		const double needed = verdictOn(few, 100).maxDisplacement;
		ASSERT_GT(needed, 0);
		for (const double share : {0.2, 1.5}) {
			const PanelVerdict ofFew = verdictOn(few, share * needed);
			const PanelVerdict ofMany = verdictOn(many, share * needed);
			EXPECT_EQ(ofFew.isPanel(), share > 1);
			EXPECT_EQ(ofMany.isPanel(), share > 1);
			EXPECT_TRUE(ofMany.disk);
			if (share > 1) {
				EXPECT_NEAR(ofMany.meanDisplacement, ofFew.meanDisplacement, 0.3 * ofFew.meanDisplacement);
			}
		}
	}
}

} // namespace
} // namespace developable::test
