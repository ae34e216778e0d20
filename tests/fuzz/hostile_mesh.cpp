// SPDX-License-Identifier: GPL-3.0-or-later
// hostile_mesh.cpp: surfaces of many kinds, and what is then done to them.
#include "hostile_mesh.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace developable::fuzz {

namespace {

/// Of the power of ten of a scale: the fourth power of a length is a number still.
constexpr double largestExponent = 60;

/// A surface before it becomes arrays.
struct Shape {
	std::vector<Eigen::Vector3d> points;
	std::vector<Eigen::Vector3i> triangles;

	int pointCount() const { return static_cast<int>(points.size()); }
	int triangleCount() const { return static_cast<int>(triangles.size()); }
};

Eigen::Vector3d randomPoint(Random& random, double size) {
	return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

/// Cells of two triangles each, the diagonals at random.
/// \param vertex  of a column and a row, its number
template <class Vertex>
void addCells(Random& random, int columns, int rows, const Vertex& vertex, Shape& shape) {
	for (int row = 0; row < rows; ++row)
		for (int column = 0; column < columns; ++column) {
			const int a = vertex(column, row), b = vertex(column + 1, row);
			const int c = vertex(column + 1, row + 1), d = vertex(column, row + 1);
			const bool other = random.chance(0.5);
			shape.triangles.emplace_back(a, b, other ? d : c);
			shape.triangles.emplace_back(other ? b : a, c, d);
		}
}

Shape sheet(Random& random) {
	const int columns = 1 + random.below(7), rows = 1 + random.below(7);
	const double bulge = random.oneOf({0.0, 0.1, 1.0, -3.0}), saddle = random.oneOf({0.0, 0.5});
	const double noise = random.oneOf({0.0, 0.01, 0.2});
	Shape shape;
	for (int row = 0; row <= rows; ++row)
		for (int column = 0; column <= columns; ++column) {
			const double u = double(column) / columns - 0.5, v = double(row) / rows - 0.5;
			shape.points.push_back(Eigen::Vector3d(u, v, bulge * (u * u + v * v) + saddle * u * v) +
								   randomPoint(random, noise));
		}
	addCells(
		random, columns, rows, [=](int column, int row) { return row * (columns + 1) + column; }, shape);
	return shape;
}

/// A band that is closed after any number of half turns: a tube, a Möbius band, or twisted more than that.
Shape band(Random& random) {
	const int columns = 3 + random.below(9), rows = 1 + random.below(4), halfTurns = random.below(4);
	const double width = random.oneOf({0.05, 0.5, 1.5}), noise = random.oneOf({0.0, 0.05});
	Shape shape;
	for (int row = 0; row <= rows; ++row)
		for (int column = 0; column < columns; ++column) {
			const double turn = 2 * pi * column / columns, across = width * (double(row) / rows - 0.5);
			const double tilt = halfTurns * turn / 2, radius = 1 + across * std::sin(tilt);
			shape.points.push_back(
				Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), across * std::cos(tilt)) +
				randomPoint(random, noise));
		}
	addCells(
		random, columns, rows,
		[=](int column, int row) {
			const bool upsideDown = column == columns && halfTurns % 2 == 1;
			return (upsideDown ? rows - row : row) * columns + column % columns;
		},
		shape);
	return shape;
}

/// A torus, mostly with a hole: a patch with a handle.
Shape torus(Random& random) {
	const int columns = 3 + random.below(5), rows = 3 + random.below(4);
	Shape shape;
	for (int row = 0; row < rows; ++row)
		for (int column = 0; column < columns; ++column) {
			const double u = 2 * pi * column / columns, v = 2 * pi * row / rows;
			const double radius = 2 + std::cos(v);
			shape.points.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
		}
	addCells(
		random, columns, rows, [=](int column, int row) { return (row % rows) * columns + column % columns; },
		shape);
	if (random.chance(0.8))
		shape.triangles.pop_back();
	return shape;
}

/// Triangles round one vertex, with more or less than 2π, open or closed.
Shape fan(Random& random) {
	const int spokes = 3 + random.below(10);
	const double turns = random.oneOf({0.5, 1.0, 1.0, 2.0}), height = random.oneOf({0.0, 0.3, 4.0});
	Shape shape;
	shape.points.emplace_back(0, 0, height);
	for (int spoke = 0; spoke < spokes; ++spoke) {
		const double angle = 2 * pi * turns * spoke / spokes;
		shape.points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * random.between(-1, 1));
		shape.triangles.emplace_back(0, 1 + spoke, 1 + (spoke + 1) % spokes);
	}
	if (random.chance(0.3))
		shape.triangles.pop_back();
	return shape;
}

/// An octahedron, mostly with some triangles missing.
Shape ball(Random& random) {
	Shape shape;
	shape.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
	shape.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
					   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
	shape.triangles.resize(8 - random.below(4));
	return shape;
}

/// Triangles between any vertices.
Shape heap(Random& random) {
	Shape shape;
	const int points = 4 + random.below(10);
	for (int i = 0; i < points; ++i)
		shape.points.push_back(randomPoint(random, 1));
	for (int t = 1 + random.below(2 * points); t > 0; --t)
		shape.triangles.emplace_back(random.below(points), random.below(points), random.below(points));
	return shape;
}

Shape anyShape(Random& random) {
	switch (random.below(10)) {
	case 0:
	case 1:
		return band(random);
	case 2:
		return torus(random);
	case 3:
		return fan(random);
	case 4:
		return ball(random);
	case 5:
		return heap(random);
	default:
		return sheet(random);
	}
}

/// Beside the first shape, far off, across it, or sewn to it where vertices coincide.
void join(Random& random, const Shape& other, Shape& shape) {
	const int first = shape.pointCount();
	Eigen::Vector3d shift = random.oneOf({0.0, 1.0, 100.0}) * randomPoint(random, 1);
	if (random.chance(0.5)) // in one vertex at least
		shift = shape.points[random.below(first)] - other.points[random.below(other.pointCount())];
	for (const Eigen::Vector3d& point : other.points)
		shape.points.emplace_back(point + shift);
	for (const Eigen::Vector3i& triangle : other.triangles)
		shape.triangles.emplace_back(triangle.array() + first);
}

/// One fault in what is joined to what.
void spoilTriangles(Random& random, Shape& shape) {
	const int t = random.below(shape.triangleCount()), p = random.below(shape.pointCount());
	switch (random.below(6)) {
	case 0: // twice there
		shape.triangles.push_back(shape.triangles[t]);
		break;
	case 1: // turned round
		std::swap(shape.triangles[t][0], shape.triangles[t][1]);
		break;
	case 2: // a third one at an edge
		shape.triangles.emplace_back(shape.triangles[t][0], shape.triangles[t][1], p);
		break;
	case 3: // joined to a vertex elsewhere
		shape.triangles[t][random.below(3)] = p;
		break;
	case 4: // missing
		if (shape.triangleCount() > 1)
			shape.triangles.erase(shape.triangles.begin() + t);
		break;
	default: // a vertex of its own that coincides with another
		shape.points.push_back(shape.points[shape.triangles[t][0]]);
		shape.triangles[t][0] = shape.pointCount() - 1;
	}
}

/// One fault in where the points are.
void spoilPoints(Random& random, Shape& shape) {
	const int p = random.below(shape.pointCount()), other = random.below(shape.pointCount());
	switch (random.below(5)) {
	case 0: // next to another, so that triangles get thin
		shape.points[p] = shape.points[other] + randomPoint(random, random.magnitude(-16, -2));
		break;
	case 1: // far off
		shape.points[p] = randomPoint(random, random.magnitude(0, 6));
		break;
	case 2: // on another
		shape.points[p] = shape.points[other];
		break;
	case 3: // of no triangle
		shape.points.push_back(randomPoint(random, 1));
		break;
	default: { // in line with two others
		const double share = random.between(-0.5, 1.5);
		const int third = random.below(shape.pointCount());
		shape.points[p] = share * shape.points[other] + (1 - share) * shape.points[third];
	}
	}
}

/// Scale, place and rounding of the whole.
void spoilCoordinates(Random& random, Positions& positions) {
	if (random.chance(0.1)) { // to few bits, so that much coincides
		const double steps = std::ldexp(1, 1 + random.below(6));
		positions = (positions * steps).array().round() / steps;
	}
	if (random.chance(0.1)) // far from the origin
		positions.colwise() += randomPoint(random, random.magnitude(0, 12));
	if (random.chance(0.1)) // flattened
		positions.row(random.below(3)) *= random.oneOf({0.0, 1e-9, 1e-3});
	if (random.chance(0.2))
		positions *= random.magnitude(-6, 6);
	if (random.chance(0.05))
		positions *= random.magnitude(-largestExponent, largestExponent);
	if (random.chance(0.01))
		positions(random.below(3), random.below(static_cast<int>(positions.cols()))) =
			random.oneOf({std::nan(""), std::numeric_limits<double>::infinity()});
	if (random.chance(0.2)) // as a host with float holds it
		positions = positions.cast<float>().cast<double>();
}

std::vector<int> randomLabels(Random& random, int triangles) {
	const bool perTriangle = random.chance(0.7);
	std::vector<int> labels;
	labels.reserve(3 * static_cast<std::size_t>(triangles));
	for (int corner = 0; corner < 3 * triangles; ++corner)
		labels.push_back(perTriangle && corner % 3 > 0 ? labels.back() : random.below(2));
	return labels;
}

} // namespace

TriangleMesh hostileMesh(Random& random) {
	Shape shape = anyShape(random);
	while (random.chance(0.3))
		join(random, anyShape(random), shape);
	const double carefulness = random.oneOf({1.0, 1.0, 0.6, 0.2});
	while (!random.chance(carefulness))
		random.chance(0.5) ? spoilTriangles(random, shape) : spoilPoints(random, shape);

	TriangleMesh mesh;
	mesh.positions.resize(3, shape.pointCount());
	for (int i = 0; i < shape.pointCount(); ++i)
		mesh.positions.col(i) = shape.points[i];
	spoilCoordinates(random, mesh.positions);
	mesh.triangles.resize(3, shape.triangleCount());
	for (int t = 0; t < shape.triangleCount(); ++t)
		mesh.triangles.col(t) = shape.triangles[t];
	const double selected = random.oneOf({0.0, 0.1, 0.9, 1.0});
	for (int i = 0; i < shape.pointCount(); ++i)
		mesh.vertexSelected.push_back(random.chance(selected));
	for (int t = 0; t < shape.triangleCount(); ++t)
		mesh.triangleSelected.push_back(random.chance(selected));
	mesh.face.resize(shape.triangleCount());
	std::iota(mesh.face.begin(), mesh.face.end(), 0);
	if (random.chance(0.2))
		mesh.cornerLabel = randomLabels(random, shape.triangleCount());
	mesh.leastHeightRatio = random.oneOf({1e-12, 1e-12, 1e-6});
	return mesh;
}

PatchOptions hostilePatchOptions(Random& random, const TriangleMesh& mesh) {
	PatchOptions options;
	options.onlySelected = random.chance(0.15);
	options.fixBoundary = random.chance(0.2);
	options.fixSelected = random.chance(0.3);
	if (random.chance(0.2))
		options.weldDistance = boxDiagonal(mesh.positions) * random.magnitude(-12, 0);
	if (random.chance(0.02))
		options.weldDistance = random.oneOf({-1.0, std::nan(""), std::numeric_limits<double>::infinity()});
	return options;
}

} // namespace developable::fuzz
