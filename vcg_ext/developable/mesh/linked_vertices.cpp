// SPDX-License-Identifier: GPL-3.0-or-later
// linked_vertices.cpp: finds the vertices that coincide.
#include "linked_vertices.h"

#include "exceptions.h"
#include "grouping.h"
#include "indices.h"
#include "where.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace developable::detail {

namespace {

/// Links vertices with equal coordinates.
void linkEqual(const Positions& positions, const std::vector<int>& vertices, DisjointSets& sets) {
	const auto coordinates = [&](int v) {
		return std::array<double, 3>{positions(0, v), positions(1, v), positions(2, v)};
	};
	std::vector<int> sorted = vertices;
	std::stable_sort(sorted.begin(), sorted.end(),
					 [&](int a, int b) { return coordinates(a) < coordinates(b); });
	for (std::size_t i = 1; i < sorted.size(); ++i)
		if (coordinates(sorted[i - 1]) == coordinates(sorted[i]))
			sets.unite(sorted[i - 1], sorted[i]);
}

/// Links vertices at most a distance apart, found through a grid of cells as wide as that distance. The
/// caller has made sure that no triangle is that small, so that a cell holds few vertices.
void linkNear(const Positions& positions, const std::vector<int>& vertices, double distance,
			  DisjointSets& sets) {
	using Cell = std::array<std::int64_t, 3>;
	struct Hash {
		std::size_t operator()(const Cell& c) const {
			return static_cast<std::size_t>(c[0]) * 73856093u ^ static_cast<std::size_t>(c[1]) * 19349663u ^
				   static_cast<std::size_t>(c[2]) * 83492791u;
		}
	};
	std::unordered_map<Cell, std::vector<int>, Hash> grid;
	for (const int vertex : vertices) {
		Cell cell;
		for (int axis = 0; axis < 3; ++axis)
			cell[axis] = static_cast<std::int64_t>(std::floor(positions(axis, vertex) / distance));
		for (int neighbour = 0; neighbour < 27; ++neighbour) {
			const auto found = grid.find(
				{cell[0] + neighbour % 3 - 1, cell[1] + neighbour / 3 % 3 - 1, cell[2] + neighbour / 9 - 1});
			if (found == grid.end())
				continue;
			for (const int other : found->second)
				if ((positions.col(vertex) - positions.col(other)).norm() <= distance)
					sets.unite(vertex, other);
		}
		grid[cell].push_back(vertex);
	}
}

void throwIfLinkedWithin(const TriangleMesh& mesh, const std::vector<int>& triangles) {
	if (!triangles.empty())
		throw DegenerateTriangle("The weld distance would link two corners of " +
								 counted(triangles.size(), "triangle", "triangles") +
								 ": choose a weld distance shorter than every edge." +
								 seeFace(mesh, triangles.front()));
}

std::vector<int> trianglesWithEdgesWithin(const TriangleMesh& mesh, double distance) {
	return indicesWhere(mesh.triangleCount(), [&](int t) {
		const auto triangle = mesh.triangles.col(t);
		for (int corner = 0; corner < 3; ++corner)
			if ((mesh.positions.col(triangle[corner]) - mesh.positions.col(triangle[nextCorner(corner)]))
					.norm() <= distance)
				return true;
		return false;
	});
}

} // namespace

Numbering numberPlaces(const TriangleMesh& mesh, double weldDistance) {
	std::vector<char> used(mesh.vertexCount(), 0);
	for (const int vertex : mesh.triangles.reshaped())
		used[vertex] = 1;
	std::vector<int> vertices;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		if (used[vertex])
			vertices.push_back(vertex);

	// Below the spacing of the numbers themselves, near means equal; the grid's cells would overflow.
	const bool nearMeansEqual = weldDistance < 1e-15 * mesh.positions.cwiseAbs().maxCoeff();
	DisjointSets sets(mesh.vertexCount());
	if (weldDistance > 0 && !nearMeansEqual) {
		throwIfLinkedWithin(mesh, trianglesWithEdgesWithin(mesh, weldDistance));
		linkNear(mesh.positions, vertices, weldDistance, sets);
	} else {
		linkEqual(mesh.positions, vertices, sets);
	}

	Numbering places;
	places.number.assign(mesh.vertexCount(), -1);
	for (const int vertex : vertices) {
		int& number = places.number[sets.find(vertex)];
		if (number < 0)
			number = places.count++;
		places.number[vertex] = number;
	}
	if (weldDistance > 0)
		throwIfLinkedWithin(mesh, indicesWhere(mesh.triangleCount(), [&](int t) {
								const auto triangle = mesh.triangles.col(t);
								const int a = places.number[triangle[0]], b = places.number[triangle[1]],
										  c = places.number[triangle[2]];
								return a == b || b == c || c == a;
							}));
	return places;
}

} // namespace developable::detail
