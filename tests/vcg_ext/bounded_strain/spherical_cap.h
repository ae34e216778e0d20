// SPDX-License-Identifier: GPL-3.0-or-later
// spherical_cap.h: a round cap of the unit sphere.
#pragma once

#include "support/shapes.h"

namespace developable::test {

/// \param angle  from the pole to the rim, rad
inline TriangleMesh sphericalCap(double angle, int rings = 10) {
	std::vector<Eigen::Vector3d> points = {{0, 0, 1}};
	std::vector<Eigen::Vector3i> triangles;
	const auto index = [](int ring, int i) {
		return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + (i + 6 * ring) % (6 * ring);
	};
	for (int ring = 1; ring <= rings; ++ring) {
		for (int i = 0; i < 6 * ring; ++i) {
			const double latitude = angle * ring / rings, longitude = pi * i / (3.0 * ring);
			points.emplace_back(std::sin(latitude) * std::cos(longitude),
								std::sin(latitude) * std::sin(longitude), std::cos(latitude));
		}
		for (int sector = 0; sector < 6; ++sector)
			for (int i = 0; i < ring; ++i) {
				const int outer = sector * ring + i, inner = sector * (ring - 1) + i;
				triangles.emplace_back(index(ring, outer), index(ring, outer + 1), index(ring - 1, inner));
				if (i + 1 < ring)
					triangles.emplace_back(index(ring - 1, inner), index(ring, outer + 1),
										   index(ring - 1, inner + 1));
			}
	}
	Positions positions(3, points.size());
	for (std::size_t i = 0; i < points.size(); ++i)
		positions.col(i) = points[i];
	Eigen::Matrix3Xi corners(3, triangles.size());
	for (std::size_t t = 0; t < triangles.size(); ++t)
		corners.col(t) = triangles[t];
	return makeMesh(positions, corners);
}

} // namespace developable::test
