// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_intersection.cpp: hands two triangles to vcglib's test.
#include "triangle_intersection.h"

#include <vcg/space/intersection/triangle_triangle3.h>

namespace developable::detail {

bool intersectUnjoined(const PlacedTriangle& a, const PlacedTriangle& b) {
	const auto point = [](const PlacedTriangle& t, int corner) {
		return vcg::Point3d(t.corners(0, corner), t.corners(1, corner), t.corners(2, corner));
	};
	return vcg::NoDivTriTriIsect(point(a, 0), point(a, 1), point(a, 2), point(b, 0), point(b, 1),
								 point(b, 2));
}

} // namespace developable::detail
