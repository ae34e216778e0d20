// SPDX-License-Identifier: GPL-3.0-or-later
// indices.h: how triangles, their corners and their half edges are numbered everywhere.
//
// Triangle t has the corners 3t, 3t + 1 and 3t + 2. A half edge has the number of the corner that it begins
// at and runs to the next corner of its triangle. In a 3 x triangles matrix, corner c is entry c of its
// storage. These functions also serve the corners 0, 1 and 2 of a single triangle.
#pragma once

namespace developable {

constexpr int triangleOf(int corner) {
	return corner / 3;
}

/// Which of its triangle's corners it is: 0, 1 or 2.
constexpr int cornerInTriangle(int corner) {
	return corner % 3;
}

/// The corner of a triangle by its number there, 0 to 2.
constexpr int cornerOf(int triangle, int number) {
	return 3 * triangle + number;
}

/// Where the half edge that begins at a corner ends.
constexpr int nextCorner(int corner) {
	return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Where the half edge that ends at a corner begins.
constexpr int previousCorner(int corner) {
	return corner % 3 == 0 ? corner + 2 : corner - 1;
}

} // namespace developable
