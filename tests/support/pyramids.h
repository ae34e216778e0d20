// SPDX-License-Identifier: GPL-3.0-or-later
// pyramids.h: meshes whose angle defects are known: pyramids on common corners and edges, and a sleeve.
#pragma once

#include "support/shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace developable::test {

using Point = Eigen::Vector3d;

inline const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), origin(0, 0, 0);

inline double angleAt(const Point& apex, const Point& a, const Point& b) {
	return std::acos((a - apex).normalized().dot((b - apex).normalized()));
}

/// Angle defect of a vertex with these neighbours round it.
inline double fanDefect(const Point& apex, const std::vector<Point>& ring) {
	double defect = 2 * pi;
	for (std::size_t i = 0; i < ring.size(); ++i)
		defect -= angleAt(apex, ring[i], ring[(i + 1) % ring.size()]);
	return defect;
}

/// A cone of triangles: the ring's points are vertices 0 to n - 1, the apex is vertex n.
inline TriangleMesh fan(const Point& apex, const std::vector<Point>& ring) {
	const int count = static_cast<int>(ring.size());
	Positions positions(3, count + 1);
	Eigen::Matrix3Xi triangles(3, count);
	for (int i = 0; i < count; ++i) {
		positions.col(i) = ring[i];
		triangles.col(i) << i, (i + 1) % count, count;
	}
	positions.col(count) = apex;
	return makeMesh(positions, triangles);
}

/// A square pyramid without its base, on the square from a corner along two sides, its apex a height above.
inline TriangleMesh pyramid(const Point& corner, const Point& side, const Point& other, double height) {
	const Point apex = corner + (side + other) / 2 + height * side.cross(other).normalized();
	return fan(apex, {corner, corner + side, corner + side + other, corner + other});
}

/// g at the apex of a pyramid over the unit square: the cosine of each of its four angles is h²/(½ + h²).
inline double pyramidDefect(double height) {
	return 2 * pi - 4 * std::acos(height * height / (0.5 + height * height));
}

/// A barrel of unit height, closed at u = 1 to the last bit but for a gap.
inline Surface sleeve(double gap) {
	return [gap](double u, double v) -> Point {
		const double radius = 1 + v * (1 - v), angle = u < 1 ? 2 * pi * u : 0;
		return {radius * std::cos(angle), radius * std::sin(angle), u < 1 ? v : v + gap};
	};
}

/// The same mesh with one vertex for those that coincide.
inline TriangleMesh shared(const TriangleMesh& mesh) {
	std::map<std::array<double, 3>, int> numbers;
	std::vector<int> number;
	for (const auto& p : mesh.positions.colwise())
		number.push_back(
			numbers.emplace(std::array<double, 3>{p[0], p[1], p[2]}, int(numbers.size())).first->second);
	Positions positions(3, numbers.size());
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		positions.col(number[vertex]) = mesh.positions.col(vertex);
	Eigen::Matrix3Xi triangles = mesh.triangles;
	for (int& vertex : triangles.reshaped())
		vertex = number[vertex];
	return makeMesh(positions, triangles);
}

/// Two pyramids on a common edge and one apart; the first selected by one of its faces.
inline TriangleMesh oneSelectedOfThree() {
	TriangleMesh mesh = together(together(pyramid(origin, x, y, 0.2), pyramid(x, x, y, 0.9)),
								 pyramid(Point(7, 0, 0), x, y, 0.4));
	mesh.triangleSelected[2] = 1;
	return mesh;
}

} // namespace developable::test
