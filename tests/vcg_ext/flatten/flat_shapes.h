// SPDX-License-Identifier: GPL-3.0-or-later
// flat_shapes.h: shapes to lay flat, and laying them flat.
#pragma once

#include "developable/flatten/flatten.h"
#include "developable/flatten/panel_maker.h"

#include "support/shapes.h"

#include <algorithm>

namespace developable::test {

inline FlatPatterns flattened(const TriangleMesh& mesh, const FlattenOptions& options = {}) {
	const PatchAssembly assembly = assembled(mesh);
	return flattenPatches(assembly, assembly.originalPositions, options);
}

/// A surface that is closed in u: columns vertices round, rows along.
inline TriangleMesh ring(int columns, int rows, const Surface& surface) {
	const TriangleMesh open = grid(columns + 1, rows, surface);
	Positions positions(3, columns * rows);
	const auto vertex = [&](int v) { return v / (columns + 1) * columns + v % (columns + 1) % columns; };
	for (int v = 0; v < open.vertexCount(); ++v)
		if (v % (columns + 1) < columns)
			positions.col(vertex(v)) = open.positions.col(v);
	return makeMesh(positions, open.triangles.unaryExpr(vertex));
}

inline Eigen::Vector3d tube(double u, double v) {
	return {std::cos(2 * pi * u), std::sin(2 * pi * u), 3 * v};
}

inline Surface bump(double height, double steepness) {
	return [=](double u, double v) -> Eigen::Vector3d {
		const double distance = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
		return {u, v, height * std::exp(-steepness * distance)};
	};
}

/// Without the triangles whose vertices all satisfy a condition.
template <class Condition>
TriangleMesh without(const TriangleMesh& mesh, const Condition& condition) {
	std::vector<int> kept;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const auto triangle = mesh.triangles.col(t);
		if (!std::all_of(triangle.begin(), triangle.end(),
						 [&](int v) { return condition(Eigen::Vector3d(mesh.positions.col(v))); }))
			kept.push_back(t);
	}
	return makeMesh(mesh.positions, mesh.triangles(Eigen::all, kept));
}

inline TriangleMesh withHole(const TriangleMesh& mesh, const Eigen::Vector2d& centre, double radius) {
	return without(mesh, [&](const Eigen::Vector3d& p) { return (p.head<2>() - centre).norm() < radius; });
}

/// Of an assembly of one patch.
inline detail::PanelMesh onlyPanel(const PatchAssembly& assembly) {
	return detail::PanelMaker(assembly, assembly.originalPositions).panel(0);
}

} // namespace developable::test
