// SPDX-License-Identifier: GPL-3.0-or-later
// corkscrew.h: a border that overlaps itself when laid flat.
#pragma once

#include "support/shapes.h"

namespace developable::test {

/// A fan of eight triangles round a border vertex, the first, at which their angles add up to a little more
/// than an angle, rad.
inline TriangleMesh corkscrew(double angle) {
	const int triangles = 8;
	Positions positions(3, triangles + 2);
	positions.col(0).setZero();
	for (int i = 0; i <= triangles; ++i) {
		const double at = angle * i / triangles;
		positions.col(1 + i) << std::cos(at), std::sin(at), 0.05 * i;
	}
	Eigen::Matrix3Xi fan(3, triangles);
	for (int i = 0; i < triangles; ++i)
		fan.col(i) << 0, 1 + i, 2 + i;
	return makeMesh(positions, fan);
}

} // namespace developable::test
