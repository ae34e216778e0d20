// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_contours.h: the polygons of a triangle mesh whose faux edges join triangles to polygons.
#pragma once

#include "joined_faces.h"

namespace developable::detail {

/// A polygon made of triangles.
struct Polygon {
	std::vector<int> triangles;
	/// The half edges round it, each beginning where the last one ended; empty when its triangles do not form
	/// a disk of consistent orientation with all vertices on its rim, or
	/// a texture seam runs through it.
	std::vector<int> contour;
};

/// Finds the polygons of a mesh.
class PolygonFinder {
public:
	/// \param faux  per half edge 3 * triangle + corner, true for the diagonals inside polygons
	PolygonFinder(const TriangleMesh& mesh, const std::vector<char>& faux)
		: mesh_(mesh), faux_(faux), across_(3 * mesh.triangleCount(), -1),
		  halfEdgeFrom_(mesh.vertexCount(), -1) {
		HalfEdgesByEnds(mesh).forEachEdge([this](auto first, auto last) {
			if (last - first != 2 || !faux_[first[0]] || !faux_[first[1]])
				return;
			across_[first[0]] = first[1];
			across_[first[1]] = first[0];
		});
	}

	/// All polygons of more than one triangle, and triangles with a faux edge that nothing matches.
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
		return std::any_of(polygon.triangles.begin(), polygon.triangles.end(),
						   [this](int t) { return faux_[3 * t] || faux_[3 * t + 1] || faux_[3 * t + 2]; });
	}

	std::vector<int> contourOf(const Polygon& polygon) {
		std::vector<int> rim;
		bool isDisk = true;
		for (const int triangle : polygon.triangles)
			for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
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

} // namespace developable::detail
