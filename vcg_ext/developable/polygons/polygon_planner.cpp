// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_planner.cpp: polygons whose triangles are not constrained Delaunay, and the faces that theirs take.
#include "polygon_planner.h"

#include "constrained_delaunay.h"
#include "polygon_contours.h"
#include "projected_polygon.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

class PolygonPlanner {
public:
	PolygonPlanner(const TriangleMesh& mesh, const std::vector<char>& faux)
		: mesh_(mesh), cornerOfVertex_(mesh.vertexCount(), -1) {
		for (const Polygon& polygon : findPolygons(mesh, faux))
			plan(polygon);
		skipPlansThatShareEdges();
		for (const Plan& plan : plans_) {
			result_.newDiagonals += static_cast<int>(plan.newDiagonals.size());
			result_.triangles.insert(result_.triangles.end(), plan.triangles.begin(), plan.triangles.end());
		}
	}

	const PolygonPlan& result() const { return result_; }

private:
	/// What changes in one polygon.
	struct Plan {
		std::vector<NewTriangle> triangles;
		std::vector<Edge> newDiagonals; // by mesh vertices
	};

	void plan(const Polygon& polygon) {
		++result_.polygons;
		const int corners = static_cast<int>(polygon.contour.size());
		Positions contour(3, corners);
		for (int corner = 0; corner < corners; ++corner)
			contour.col(corner) = mesh_.positions.col(vertexAt(mesh_, polygon.contour[corner]));
		const Eigen::Matrix2Xd projected = corners > 0 ? projectedContour(contour) : Eigen::Matrix2Xd(2, 0);
		if (corners == 0 || !isSimplePolygon(projected)) {
			++result_.skipped;
			return;
		}
		const Eigen::Matrix3Xi before = trianglesByCorner(polygon);
		if (!isConstrainedDelaunay(projected, before, delaunayTolerance(contour)))
			planChange(polygon, before, constrainedDelaunay(projected));
	}

	/// The polygon's triangles, their vertices numbered along its contour.
	Eigen::Matrix3Xi trianglesByCorner(const Polygon& polygon) {
		for (std::size_t corner = 0; corner < polygon.contour.size(); ++corner)
			cornerOfVertex_[vertexAt(mesh_, polygon.contour[corner])] = static_cast<int>(corner);
		Eigen::Matrix3Xi result(3, polygon.triangles.size());
		for (std::size_t i = 0; i < polygon.triangles.size(); ++i)
			for (int corner = 0; corner < 3; ++corner)
				result(corner, i) = cornerOfVertex_[mesh_.triangles(corner, polygon.triangles[i])];
		return result;
	}

	static std::array<int, 3> sortedCorners(const Eigen::Matrix3Xi& triangles, Eigen::Index column) {
		std::array<int, 3> corners = {triangles(0, column), triangles(1, column), triangles(2, column)};
		std::sort(corners.begin(), corners.end());
		return corners;
	}

	/// Triangles that stay keep their face, with all that it carries; the others share out the faces left
	/// over.
	void planChange(const Polygon& polygon, const Eigen::Matrix3Xi& before, const Eigen::Matrix3Xi& after) {
		std::map<std::array<int, 3>, int> replaced;
		for (Eigen::Index i = 0; i < before.cols(); ++i)
			replaced[sortedCorners(before, i)] = polygon.triangles[i];
		std::vector<Eigen::Index> added;
		for (Eigen::Index i = 0; i < after.cols(); ++i)
			if (replaced.erase(sortedCorners(after, i)) == 0)
				added.push_back(i);
		std::vector<int> free;
		free.reserve(replaced.size());
		for (const auto& [corners, triangle] : replaced)
			free.push_back(triangle);
		std::sort(free.begin(), free.end());

		Plan plan;
		for (std::size_t i = 0; i < added.size(); ++i)
			plan.triangles.push_back(newTriangle(polygon, free[i], after.col(added[i])));
		const std::set<Edge> old = diagonals(before);
		for (const auto& [a, b] : diagonals(after))
			if (old.count({a, b}) == 0)
				plan.newDiagonals.push_back(
					edgeBetween(vertexAt(mesh_, polygon.contour[a]), vertexAt(mesh_, polygon.contour[b])));
		plans_.push_back(std::move(plan));
	}

	static NewTriangle newTriangle(const Polygon& polygon, int face, const Eigen::Vector3i& corners) {
		NewTriangle result = {face, {}, {}};
		const int count = static_cast<int>(polygon.contour.size());
		for (int side = 0; side < 3; ++side) {
			result.halfEdge[side] = polygon.contour[corners[side]];
			result.diagonal[side] = corners[nextCorner(side)] != (corners[side] + 1) % count;
		}
		return result;
	}

	/// A diagonal that is an edge elsewhere would get a third and a fourth face.
	void skipPlansThatShareEdges() {
		std::multimap<Edge, std::size_t> wanted;
		for (std::size_t plan = 0; plan < plans_.size(); ++plan)
			for (const Edge& edge : plans_[plan].newDiagonals)
				wanted.emplace(edge, plan);
		if (wanted.empty())
			return;
		std::set<std::size_t> skipped;
		HalfEdgesByEnds(mesh_).forEachEdge([&](auto first, auto) {
			const auto range =
				wanted.equal_range(edgeBetween(vertexAt(mesh_, *first), vertexAt(mesh_, nextCorner(*first))));
			for (auto plan = range.first; plan != range.second; ++plan)
				skipped.insert(plan->second);
		});
		std::set<Edge> added;
		std::vector<Plan> kept;
		for (std::size_t i = 0; i < plans_.size(); ++i) {
			const auto& edges = plans_[i].newDiagonals;
			if (skipped.count(i) > 0 || std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
					return added.count(edge) > 0;
				})) {
				++result_.skipped;
				continue;
			}
			added.insert(edges.begin(), edges.end());
			kept.push_back(std::move(plans_[i]));
		}
		plans_ = std::move(kept);
	}

	const TriangleMesh& mesh_;
	std::vector<int> cornerOfVertex_; // along the contour of the polygon that is looked at
	std::vector<Plan> plans_;
	PolygonPlan result_;
};

} // namespace

PolygonPlan planPolygons(const TriangleMesh& mesh, const std::vector<char>& faux) {
	return PolygonPlanner(mesh, faux).result();
}

} // namespace developable::detail
