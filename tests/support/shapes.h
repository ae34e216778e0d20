// SPDX-License-Identifier: GPL-3.0-or-later
// shapes.h: shapes that tests work on, made in code.
#pragma once

#include "developable/mesh/mesh.h"

#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>

namespace developable::test {

inline TriangleMesh makeMesh(const Positions& positions, const Eigen::Matrix3Xi& triangles) {
	TriangleMesh mesh;
	mesh.positions = positions;
	mesh.triangles = triangles;
	mesh.vertexSelected.assign(positions.cols(), 0);
	mesh.triangleSelected.assign(triangles.cols(), 0);
	mesh.face.resize(triangles.cols());
	std::iota(mesh.face.begin(), mesh.face.end(), 0);
	return mesh;
}

using Surface = std::function<Eigen::Vector3d(double u, double v)>;

/// A grid of columns x rows vertices over the unit square, diagonals alternating, mapped by a surface.
inline TriangleMesh grid(int columns, int rows, const Surface& surface) {
	Positions positions(3, columns * rows);
	for (int row = 0; row < rows; ++row)
		for (int column = 0; column < columns; ++column)
			positions.col(row * columns + column) =
				surface(double(column) / (columns - 1), double(row) / (rows - 1));
	Eigen::Matrix3Xi triangles(3, 2 * (columns - 1) * (rows - 1));
	int next = 0;
	for (int row = 0; row + 1 < rows; ++row)
		for (int column = 0; column + 1 < columns; ++column) {
			const int a = row * columns + column, b = a + 1, c = b + columns, d = a + columns;
			const bool other = (row + column) % 2;
			triangles.col(next++) << a, b, (other ? d : c);
			triangles.col(next++) << (other ? b : a), c, d;
		}
	return makeMesh(positions, triangles);
}

/// The same with the inner vertices moved in the parameter domain by up to a share of the cell.
inline TriangleMesh jitteredGrid(int columns, int rows, const Surface& surface, double share = 0.25) {
	std::mt19937 random(7);
	const auto jitter = [&](double cells) {
		return share * (2.0 * random() / std::mt19937::max() - 1) / cells;
	};
	TriangleMesh mesh = grid(columns, rows, surface);
	for (int row = 1; row + 1 < rows; ++row)
		for (int column = 1; column + 1 < columns; ++column) {
			const double u = double(column) / (columns - 1) + jitter(columns - 1);
			const double v = double(row) / (rows - 1) + jitter(rows - 1);
			mesh.positions.col(row * columns + column) = surface(u, v);
		}
	return mesh;
}

inline Eigen::Vector3d flatSheet(double u, double v) {
	return {u, v, 0};
}

inline Eigen::Vector3d quarterCylinder(double u, double v) {
	return {std::cos(u * pi / 2), std::sin(u * pi / 2), v};
}

/// Part of a cone that leaves out its apex.
inline Eigen::Vector3d coneBand(double u, double v) {
	const double radius = 0.5 + 0.5 * v;
	return {radius * std::cos(2 * u), radius * std::sin(2 * u), 0.7 * v};
}

/// The same with a bump of some height, at some u.
inline Surface bumpedCone(double height, double middle) {
	return [=](double u, double v) -> Eigen::Vector3d {
		const double distance = (u - middle) * (u - middle) + (v - 0.5) * (v - 0.5);
		return coneBand(u, v) + height * std::exp(-25 * distance) * Eigen::Vector3d::UnitZ();
	};
}

/// A cap of a sphere of the given radius over a square of side radius.
inline Surface sphereCap(double radius) {
	return [radius](double u, double v) -> Eigen::Vector3d {
		const double x = radius * (u - 0.5), y = radius * (v - 0.5);
		return {x, y, std::sqrt(radius * radius - x * x - y * y)};
	};
}

inline Eigen::Vector3d saddle(double u, double v) {
	return {u, v, 0.6 * (u - 0.5) * (v - 0.5)};
}

/// A bent sheet with a smooth bump in the middle, as in the paper's Fig. 1.
inline Eigen::Vector3d bumpedCylinder(double u, double v) {
	const double angle = 1.2 * (u - 0.5), distance = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
	const double radius = 1 + 0.05 * std::exp(-20 * distance);
	return {radius * std::sin(angle), v, radius * std::cos(angle)};
}

inline Eigen::Vector3d largeSaddle(double u, double v) {
	const double x = 2 * u - 1, y = 2 * v - 1;
	return {x, y, (x * x - y * y) / 2};
}

inline Eigen::Vector3d wave(double u, double v) {
	return {u, v, 0.05 * std::sin(6 * u) * std::cos(5 * v)};
}

inline Eigen::Vector3d steepBump(double u, double v) {
	const double x = u - 0.5, y = v - 0.5;
	return {x, y, 0.35 * std::exp(-30 * (x * x + y * y))};
}

/// The instep of a shoe: a tunnel that widens and rises.
inline Eigen::Vector3d vamp(double u, double v) {
	const double angle = 3 * (u - 0.5), width = 0.4 + 0.25 * v * v, height = 0.35 + 0.5 * v * v;
	return {width * std::sin(angle), 1.2 * v, height * std::cos(angle)};
}

/// A closed regular octahedron.
inline TriangleMesh octahedron() {
	Positions positions(3, 6);
	positions << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
	Eigen::Matrix3Xi triangles(3, 8);
	triangles << 0, 2, 1, 3, 2, 1, 3, 0, 2, 1, 3, 0, 0, 2, 1, 3, 4, 4, 4, 4, 5, 5, 5, 5;
	return makeMesh(positions, triangles);
}

/// A sphere: the octahedron with every triangle cut in four, several times, on the unit sphere times radius.
inline TriangleMesh sphere(double radius, int subdivisions) {
	TriangleMesh mesh = octahedron();
	for (int round = 0; round < subdivisions; ++round) {
		std::vector<Eigen::Vector3d> points(mesh.positions.colwise().begin(), mesh.positions.colwise().end());
		std::map<std::pair<int, int>, int> middles;
		const auto middle = [&](int a, int b) {
			const auto [found, isNew] = middles.emplace(std::minmax(a, b), static_cast<int>(points.size()));
			if (isNew)
				points.push_back((mesh.positions.col(a) + mesh.positions.col(b)).normalized());
			return found->second;
		};
		Eigen::Matrix3Xi triangles(3, 4 * mesh.triangleCount());
		int next = 0;
		for (const auto& t : mesh.triangles.colwise()) {
			const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
			triangles.col(next++) << t[0], ab, ca;
			triangles.col(next++) << ab, t[1], bc;
			triangles.col(next++) << ca, bc, t[2];
			triangles.col(next++) << ab, bc, ca;
		}
		Positions positions(3, points.size());
		for (std::size_t i = 0; i < points.size(); ++i)
			positions.col(i) = points[i];
		mesh = makeMesh(positions, triangles);
	}
	mesh.positions *= radius;
	return mesh;
}

/// Two meshes as one, the second's vertices behind the first's.
inline TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
	Positions positions(3, a.vertexCount() + b.vertexCount());
	positions << a.positions, b.positions;
	Eigen::Matrix3Xi triangles(3, a.triangleCount() + b.triangleCount());
	triangles << a.triangles, (b.triangles.array() + a.vertexCount()).matrix();
	return makeMesh(positions, triangles);
}

/// A rotation about a skew axis, a scaling, and a shift.
inline Positions moved(const Positions& positions, double scale, const Eigen::Vector3d& shift) {
	const Eigen::AngleAxisd rotation(1.1, Eigen::Vector3d(1, 2, -3).normalized());
	return ((scale * rotation.toRotationMatrix()) * positions).colwise() + shift;
}

inline PatchAssembly assembled(const TriangleMesh& mesh, const PatchOptions& options = {}) {
	return assemblePatches(mesh, options);
}

/// A grid without the triangles for which a condition on the cell's column and row holds.
template <class Condition>
inline TriangleMesh without(const TriangleMesh& mesh, int columns, const Condition& condition) {
	std::vector<int> kept;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const int cell = t / 2;
		if (!condition(cell % (columns - 1), cell / (columns - 1)))
			kept.push_back(t);
	}
	return makeMesh(mesh.positions, mesh.triangles(Eigen::all, kept));
}

inline TriangleMesh withTwoHoles(int columns, const Surface& surface) {
	return without(jitteredGrid(columns, columns, surface), columns, [&](int column, int row) {
		const double u = double(column) / columns, v = double(row) / columns;
		return std::hypot(u - 0.3, v - 0.35) < 0.1 || std::hypot(u - 0.65, v - 0.6) < 0.12;
	});
}

/// With every coordinate moved by up to two shares of the mean edge length.
inline TriangleMesh noisy(TriangleMesh mesh, double shareOfEdge) {
	const double amount = shareOfEdge * meanEdgeLength(assembled(mesh));
	std::mt19937 random(11);
	for (double& coordinate : mesh.positions.reshaped())
		coordinate += amount * (4.0 * random() / std::mt19937::max() - 2); // standard deviation 1.15
	return mesh;
}

} // namespace developable::test
