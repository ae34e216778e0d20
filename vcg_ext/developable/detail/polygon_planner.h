// SPDX-License-Identifier: GPL-3.0-or-later
// polygon_planner.h: which triangles of a mesh's polygons change, and how; nothing is written.
#pragma once

#include "constrained_delaunay.h"
#include "polygon_contours.h"

#include <Eigen/Eigenvalues>
#include <map>
#include <set>

namespace developable::detail {

/// By how much the sum of the two angles opposite a diagonal may exceed π, rad, as far as coordinates in
/// single precision can tell. So corners on a circle, as every rectangle's are, keep the diagonals that they
/// have whatever the rounding, and hosts of single and double precision agree.
inline double delaunayTolerance(const Positions& contour) {
	double shortest = (contour.col(0) - contour.col(contour.cols() - 1)).norm();
	for (Eigen::Index i = 1; i < contour.cols(); ++i)
		shortest = std::min(shortest, (contour.col(i) - contour.col(i - 1)).norm());
	return std::min(1e-6 * contour.cwiseAbs().maxCoeff() / shortest, 1e-3);
}

/// A contour in its least-squares plane, counterclockwise if it is simple, centred, and of a size about 1.
/// \param contour  3 x corners, any unit of length, finite
/// \return         2 x corners, dimensionless
inline Eigen::Matrix2Xd projectedContour(const Positions& contour) {
	Positions centred = contour.colwise() - contour.rowwise().mean().eval();
	const double size = centred.cwiseAbs().maxCoeff();
	if (size > 0)
		centred /= size;
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred * centred.transpose());
	Eigen::Matrix2Xd projected = axes.eigenvectors().rightCols<2>().transpose() * centred;
	double doubleArea = 0;
	for (Eigen::Index i = 0, last = projected.cols() - 1; i < projected.cols(); last = i++)
		doubleArea += projected(0, last) * projected(1, i) - projected(0, i) * projected(1, last);
	if (doubleArea < 0)
		projected.row(1) *= -1;
	return projected;
}

/// A triangle of a polygon as it will be. It takes the face of `triangle`. Its corners, and the sides that
/// begin there, carry on what the contour's half edges have; a side that is a diagonal becomes a faux edge.
struct NewTriangle {
	int triangle;
	std::array<int, 3> halfEdge;
	std::array<bool, 3> diagonal;
};

using Edge = std::pair<int, int>;

inline Edge edgeBetween(int a, int b) {
	return std::minmax(a, b);
}

/// The edges of a polygon's triangles that are not on its contour; triangles and edges by corners of the
/// contour.
inline std::set<Edge> diagonals(const Eigen::Matrix3Xi& triangles) {
	const int corners = static_cast<int>(triangles.cols()) + 2;
	std::set<Edge> result;
	for (const auto& triangle : triangles.colwise())
		for (int side = 0; side < 3; ++side)
			if (triangle[(side + 1) % 3] != (triangle[side] + 1) % corners)
				result.insert(edgeBetween(triangle[side], triangle[(side + 1) % 3]));
	return result;
}

/// True when every triangle turns counterclockwise and the angles opposite each diagonal add up to at most π
/// and the tolerance: then all empty circumcircles follow.
inline bool isConstrainedDelaunay(const Eigen::Matrix2Xd& contour, const Eigen::Matrix3Xi& triangles,
								  double tolerance) {
	std::map<Edge, Eigen::Vector2d> oppositeAngle; // of the first triangle at an edge: cosine and sine
	for (const auto& triangle : triangles.colwise())
		for (int corner = 0; corner < 3; ++corner) {
			const int at = triangle[corner], next = triangle[(corner + 1) % 3],
					  last = triangle[(corner + 2) % 3];
			const Eigen::Vector2d a = (contour.col(next) - contour.col(at)).normalized();
			const Eigen::Vector2d b = (contour.col(last) - contour.col(at)).normalized();
			const Eigen::Vector2d angle(a.dot(b), a[0] * b[1] - a[1] * b[0]);
			if (!(angle[1] > 0))
				return false;
			const auto [other, isFirst] = oppositeAngle.emplace(edgeBetween(next, last), angle);
			if (isFirst)
				continue;
			const double sineOfSum = angle[1] * other->second[0] + angle[0] * other->second[1];
			if (sineOfSum < -tolerance)
				return false;
		}
	return true;
}

/// Plans the triangulation of all polygons of a mesh; nothing is written.
class PolygonPlanner {
public:
	PolygonPlanner(const TriangleMesh& mesh, const std::vector<char>& faux)
		: mesh_(mesh), cornerOfVertex_(mesh.vertexCount(), -1) {
		for (const Polygon& polygon : PolygonFinder(mesh, faux).polygons())
			plan(polygon);
		skipPlansThatShareEdges();
		for (const Plan& plan : plans_) {
			newDiagonalCount_ += static_cast<int>(plan.newDiagonals.size());
			triangles_.insert(triangles_.end(), plan.triangles.begin(), plan.triangles.end());
		}
	}

	int polygonCount() const { return polygonCount_; }
	int skippedCount() const { return skippedCount_; }
	int newDiagonalCount() const { return newDiagonalCount_; }
	const std::vector<NewTriangle>& triangles() const { return triangles_; } ///< those that change

private:
	/// What changes in one polygon.
	struct Plan {
		std::vector<NewTriangle> triangles;
		std::vector<Edge> newDiagonals; // by mesh vertices
	};

	void plan(const Polygon& polygon) {
		++polygonCount_;
		const int corners = static_cast<int>(polygon.contour.size());
		Positions contour(3, corners);
		for (int corner = 0; corner < corners; ++corner)
			contour.col(corner) = mesh_.positions.col(vertexAt(mesh_, polygon.contour[corner]));
		const Eigen::Matrix2Xd projected = corners > 0 ? projectedContour(contour) : Eigen::Matrix2Xd(2, 0);
		if (corners == 0 || !isSimplePolygon(projected)) {
			++skippedCount_;
			return;
		}
		const Eigen::Matrix3Xi before = trianglesByCorner(polygon);
		if (!isConstrainedDelaunay(projected, before, delaunayTolerance(contour)))
			planChange(polygon, before, ConstrainedDelaunay(projected).triangles());
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
			result.diagonal[side] = corners[(side + 1) % 3] != (corners[side] + 1) % count;
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
				++skippedCount_;
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
	std::vector<NewTriangle> triangles_;
	int polygonCount_ = 0, skippedCount_ = 0, newDiagonalCount_ = 0;
};

} // namespace developable::detail
