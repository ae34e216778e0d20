// SPDX-License-Identifier: GPL-3.0-or-later
// length_unit.cpp: the size of a mesh, as a power of two.
#include "length_unit.h"

namespace developable {

int lengthExponent(const Positions& positions, const Eigen::Matrix3Xi& triangles) {
	constexpr int ordinary = 64; // sixteenth powers of such lengths are numbers
	if (triangles.size() == 0)
		return 0;
	Eigen::Vector3d low = positions.col(triangles(0, 0)), high = low;
	for (const int vertex : triangles.reshaped()) {
		low = low.cwiseMin(positions.col(vertex));
		high = high.cwiseMax(positions.col(vertex));
	}
	const double longest = (high / 2 - low / 2).maxCoeff();
	if (!(longest > 0) || std::isinf(longest))
		return 0;
	const int exponent = std::ilogb(longest) + 1;
	return std::abs(exponent) <= ordinary ? 0 : exponent + (exponent & 1);
}

} // namespace developable
