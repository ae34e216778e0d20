// SPDX-License-Identifier: GPL-3.0-or-later
// constrained_delaunay.cpp: triangulation by CGAL.
//
// The only file that needs the headers of CGAL (5.0 or later, GPL-3.0-or-later) and of Boost; nothing is
// linked.
#include "constrained_delaunay.h"

// CGAL's own exact numbers do for predicates, so that a plugin needs no GMP beside it; and its interval
// arithmetic must leave the rounding mode alone, as other compilers' flags than -frounding-math would not
// expect it to change.
#ifndef CGAL_DISABLE_GMP
#define CGAL_DISABLE_GMP 1
#endif
#ifndef CGAL_ALWAYS_ROUND_TO_NEAREST
#define CGAL_ALWAYS_ROUND_TO_NEAREST 1
#endif
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

namespace developable::detail {

namespace {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<PlaneKernel::Point_2> planePoints(const Eigen::Matrix2Xd& contour) {
	std::vector<PlaneKernel::Point_2> points;
	points.reserve(contour.cols());
	for (const auto& point : contour.colwise())
		points.emplace_back(point[0], point[1]);
	return points;
}

/// The triangulation of one simple polygon, from its contour inwards.
class ConstrainedDelaunay {
public:
	explicit ConstrainedDelaunay(const Eigen::Matrix2Xd& contour) {
		std::vector<Triangulation::Vertex_handle> corners;
		for (const auto& point : planePoints(contour)) {
			// Corners follow each other, so the search for the next one begins at the last.
			const auto near = corners.empty() ? Triangulation::Face_handle() : corners.back()->face();
			corners.push_back(triangulation_.insert(point, near));
			corners.back()->info() = static_cast<int>(corners.size()) - 1;
		}
		for (std::size_t corner = 0; corner < corners.size(); ++corner)
			triangulation_.insert_constraint(corners[corner], corners[(corner + 1) % corners.size()]);
		markOutside();
	}

	/// The triangles inside, 3 x (corners - 2), counterclockwise.
	Eigen::Matrix3Xi triangles() const {
		Eigen::Matrix3Xi result(3, triangulation_.number_of_vertices() - 2);
		int next = 0;
		for (const auto face : triangulation_.finite_face_handles()) {
			if (face->info().outside)
				continue;
			for (int corner = 0; corner < 3; ++corner)
				result(corner, next) = face->vertex(corner)->info();
			++next;
		}
		return result;
	}

private:
	struct Side {
		bool outside = false;
	};
	using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, PlaneKernel>;
	using FaceBase = CGAL::Constrained_triangulation_face_base_2<
		PlaneKernel, CGAL::Triangulation_face_base_with_info_2<Side, PlaneKernel>>;
	using Triangulation =
		CGAL::Constrained_Delaunay_triangulation_2<PlaneKernel,
												   CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
												   CGAL::No_constraint_intersection_tag>;

	/// Everything that is reached from infinity without crossing the contour.
	void markOutside() {
		std::vector<Triangulation::Face_handle> front = {triangulation_.infinite_face()};
		front.back()->info().outside = true;
		while (!front.empty()) {
			const auto face = front.back();
			front.pop_back();
			for (int side = 0; side < 3; ++side) {
				const auto neighbour = face->neighbor(side);
				if (neighbour->info().outside || face->is_constrained(side))
					continue;
				neighbour->info().outside = true;
				front.push_back(neighbour);
			}
		}
	}

	Triangulation triangulation_;
};

} // namespace

bool isSimplePolygon(const Eigen::Matrix2Xd& contour) {
	const auto points = planePoints(contour);
	return CGAL::is_simple_2(points.begin(), points.end(), PlaneKernel());
}

Eigen::Matrix3Xi constrainedDelaunay(const Eigen::Matrix2Xd& contour) {
	return ConstrainedDelaunay(contour).triangles();
}

} // namespace developable::detail
