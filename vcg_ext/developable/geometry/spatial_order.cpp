// SPDX-License-Identifier: GPL-3.0-or-later
// spatial_order.cpp: sorts points by their Morton codes.
#include "spatial_order.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace developable {

std::vector<int> spatialOrder(const Positions& points) {
	constexpr int bits = 16;
	if (points.cols() == 0)
		return {};
	const Eigen::Vector3d low = points.rowwise().minCoeff();
	const double size = (points.rowwise().maxCoeff() - low).maxCoeff();
	const double cells = size > 0 ? ((1 << bits) - 1) / size : 0;
	std::vector<std::pair<std::uint64_t, int>> codes;
	codes.reserve(points.cols());
	for (int i = 0; i < points.cols(); ++i) {
		// What is not a number is anywhere.
		const Eigen::Vector3i cell = ((points.col(i) - low) * cells).unaryExpr([](double coordinate) {
			return coordinate > 0 && coordinate < (1 << bits) ? static_cast<int>(coordinate) : 0;
		});
		std::uint64_t code = 0;
		for (int bit = bits - 1; bit >= 0; --bit)
			for (const int coordinate : cell)
				code = code << 1 | (coordinate >> bit & 1);
		codes.emplace_back(code, i);
	}
	std::sort(codes.begin(), codes.end());
	std::vector<int> order;
	order.reserve(codes.size());
	for (const auto& [code, point] : codes)
		order.push_back(point);
	return order;
}

} // namespace developable
