// SPDX-License-Identifier: GPL-3.0-or-later
// panel_shapes.h: surfaces with panels that several tests of panels share.
#pragma once

#include "developable/panels/cut_surface.h"
#include "developable/panels/seam_chains.h"
#include "support/shapes.h"

#include <set>

namespace developable::test {

/// A mesh whose triangles are labelled by their middles.
inline std::vector<int> labelsOf(const TriangleMesh& mesh,
								 const std::function<int(const Eigen::Vector3d&)>& label) {
	std::vector<int> labels;
	labels.reserve(mesh.triangleCount());
	for (int t = 0; t < mesh.triangleCount(); ++t)
		labels.push_back(label(mesh.positions(Eigen::all, mesh.triangles.col(t)).rowwise().mean()));
	return labels;
}

/// Which of so many strips of equal width along x a point is in, within a mesh.
inline int stripAt(const TriangleMesh& mesh, int strips, const Eigen::Vector3d& point) {
	const auto x = mesh.positions.row(0);
	const double share = (point[0] - x.minCoeff()) / (x.maxCoeff() - x.minCoeff());
	return std::min(strips - 1, static_cast<int>(strips * share));
}

inline std::vector<int> strips(const TriangleMesh& mesh, int count) {
	return labelsOf(mesh, [&](const Eigen::Vector3d& point) { return stripAt(mesh, count, point); });
}

inline detail::CutSurface withPanels(const TriangleMesh& mesh, const std::vector<int>& labels) {
	detail::CutSurface surface(assembled(mesh));
	surface.relabel(labels);
	return surface;
}

/// The unit square with 8 x 8 cells, one panel.
inline detail::CutSurface square() {
	const TriangleMesh mesh = grid(9, 9, [](double u, double v) { return Eigen::Vector3d(u, v, 0); });
	return withPanels(mesh, strips(mesh, 1));
}

/// A tube, open at both ends.
inline TriangleMesh tube(int corners, int rows) {
	TriangleMesh mesh = grid(corners + 1, rows, [](double u, double v) {
		return Eigen::Vector3d(std::cos(2 * pi * u), std::sin(2 * pi * u), 2 * v);
	});
	for (int& vertex : mesh.triangles.reshaped())
		if (vertex % (corners + 1) == corners)
			vertex -= corners;
	return mesh;
}

inline std::set<std::vector<int>> panelsOf(const detail::CutSurface& surface) {
	std::set<std::vector<int>> panels;
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (!surface.trianglesOf(panel).empty())
			panels.insert(surface.trianglesOf(panel));
	return panels;
}

} // namespace developable::test
