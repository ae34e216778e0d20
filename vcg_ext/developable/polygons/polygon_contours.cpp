// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_contours.cpp: triangles joined across faux edges, and the rim of what they form.
#include "polygon_contours.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

namespace {

class PolygonFinder {
public:
	PolygonFinder(const TriangleMesh& mesh, const std::vector<char>& faux)
		: mesh_(mesh), faux_(faux), across_(mesh.triangles.size(), -1),
		  halfEdgeFrom_(mesh.vertexCount(), -1) {
		HalfEdgesByEnds(mesh).forEachEdge([this](auto first, auto last) {
			if (last - first != 2 || !faux_[first[0]] || !faux_[first[1]])
				return;
			across_[first[0]] = first[1];
			across_[first[1]] = first[0];
		});
	}

	std::vector<Polygon> polygons() {
		const Numbering numbering = numberPatches(across_);
		std::vector<Polygon> all(numbering.count), result;
		for (int triangle = 0; triangle < mesh_.triangleCount(); ++triangle)
			all[numbering.number[triangle]].triangles.push_back(triangle);
		for (Polygon& polygon : all) {
			if (!hasFauxEdge(polygon))
				continue;
			polygon.contour = contourOf(polygon);
			result.push_back(std::move(polygon));
		}
		return result;
	}

private:
	/// Its two sides run in opposite directions, and no texture seam lies on it.
	bool isDiagonal(int halfEdge) const {
		const int other = across_[halfEdge];
		return vertexAt(mesh_, halfEdge) != vertexAt(mesh_, other) && !isSeam(mesh_, halfEdge, other);
	}

	bool hasFauxEdge(const Polygon& polygon) const {
		return std::any_of(polygon.triangles.begin(), polygon.triangles.end(), [this](int t) {
			return faux_[cornerOf(t, 0)] || faux_[cornerOf(t, 1)] || faux_[cornerOf(t, 2)];
		});
	}

	std::vector<int> contourOf(const Polygon& polygon) {
		std::vector<int> rim;
		bool isDisk = true;
		for (const int triangle : polygon.triangles)
			for (int side = 0; side < 3; ++side) {
				const int h = cornerOf(triangle, side);
				if (across_[h] >= 0) {
					isDisk &= isDiagonal(h);
					continue;
				}
				isDisk &= !faux_[h] && halfEdgeFrom_[vertexAt(mesh_, h)] < 0;
				halfEdgeFrom_[vertexAt(mesh_, h)] = h;
				rim.push_back(h);
			}
		// A disk without vertices inside has two corners more than triangles; a handle or a hole, fewer.
		isDisk &= rim.size() == polygon.triangles.size() + 2;
		std::vector<int> contour;
		for (int h = rim.empty() ? -1 : rim[0]; isDisk && contour.size() < rim.size();) {
			contour.push_back(h);
			h = halfEdgeFrom_[vertexAt(mesh_, nextCorner(h))];
			isDisk = (h == rim[0]) == (contour.size() == rim.size());
		}
		for (const int h : rim)
			halfEdgeFrom_[vertexAt(mesh_, h)] = -1;
		return isDisk ? contour : std::vector<int>();
	}

	const TriangleMesh& mesh_;
	const std::vector<char>& faux_;
	std::vector<int> across_;
	std::vector<int> halfEdgeFrom_; // per vertex, while one polygon is looked at
};

} // namespace

std::vector<Polygon> findPolygons(const TriangleMesh& mesh, const std::vector<char>& faux) {
	return PolygonFinder(mesh, faux).polygons();
}

} // namespace developable::detail
