// SPDX-License-Identifier: GPL-3.0-or-later
// unfolded_hinges.cpp: lays triangles over edges, and reads off what their hinges tell.
#include "unfolded_hinges.h"

#include <Eigen/Geometry>
#include <utility>

namespace developable::detail {

namespace {

/// Where a point lies beside an edge: its foot as a share of the edge, and its height above it.
struct BesideEdge {
	double foot, height;

	BesideEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& point)
		: foot((point - from).dot(to - from) / (to - from).squaredNorm()),
		  height((to - from).cross(point - from).norm() / (to - from).norm()) {}
};

Eigen::Vector2d leftOf(const Eigen::Vector2d& direction) {
	return {-direction[1], direction[0]};
}

} // namespace

UnfoldedHinges::UnfoldedHinges(const PatchAssembly& assembly, const Eigen::VectorXd& areas, int triangle)
	: assembly_(assembly), areas_(areas) {
	const int first = cornerOf(triangle, 0);
	const Eigen::Vector3d from = positionOf(first), to = positionOf(first + 1);
	const BesideEdge third(from, to, positionOf(first + 2));
	const double length = (to - from).norm();
	points_ = {Eigen::Vector2d::Zero(), {length, 0}, {third.foot * length, third.height}};
	places_ = {assembly.placeAt(first), assembly.placeAt(first + 1), assembly.placeAt(first + 2)};
	outermost_ = {{triangle, {0, 1, 2}, -1}};
}

bool UnfoldedHinges::widen() {
	const std::size_t before = hinges_.size();
	next_.clear();
	for (const Sheet& sheet : outermost_)
		for (int number = 0; number < 3; ++number) {
			const int halfEdge = cornerOf(sheet.triangle, number), across = assembly_.across(halfEdge);
			if (across >= 0 && halfEdge != sheet.entry)
				unfold(sheet, halfEdge, across);
		}
	outermost_.swap(next_);
	return hinges_.size() > before;
}

void UnfoldedHinges::unfold(const Sheet& sheet, int halfEdge, int across) {
	const int number = cornerInTriangle(halfEdge), here = sheet.points[number],
			  there = sheet.points[nextCorner(number)], behind = sheet.points[previousCorner(number)];
	const Eigen::Vector3d from = positionOf(halfEdge), to = positionOf(nextCorner(halfEdge));
	const BesideEdge inner(from, to, positionOf(previousCorner(halfEdge))),
		outer(from, to, positionOf(previousCorner(across)));
	const double length = (to - from).norm();
	const Eigen::Vector2d along = (points_[there] - points_[here]) / length;
	const double side = leftOf(along).dot(points_[behind] - points_[here]) < 0 ? -1 : 1;
	const Eigen::Vector2d inward = side * leftOf(along);

	const int apex = static_cast<int>(points_.size());
	points_.push_back(points_[here] + outer.foot * length * along - outer.height * inward);
	places_.push_back(assembly_.placeAt(previousCorner(across)));
	Sheet next{triangleOf(across), {}, across};
	const bool sameStart = assembly_.copyAt(across) == assembly_.copyAt(halfEdge);
	next.points[cornerInTriangle(across)] = sameStart ? here : there;
	next.points[nextCorner(cornerInTriangle(across))] = sameStart ? there : here;
	next.points[previousCorner(cornerInTriangle(across))] = apex;
	next_.push_back(next);

	UnfoldedHinge hinge{{here, there, behind, apex}, {}, {}, areas_[sheet.triangle] + areas_[next.triangle]};
	const double slopeIn = length / inner.height, slopeOut = length / outer.height;
	hinge.jump = {-(1 - inner.foot) * slopeIn - (1 - outer.foot) * slopeOut,
				  -inner.foot * slopeIn - outer.foot * slopeOut, slopeIn, slopeOut};
	// Of f = ½ (H_tt t² + 2 H_tn t n + H_nn n²) in coordinates along the edge and inward.
	const double alongEdge =
		(slopeIn * inner.foot * (inner.foot - 1) + slopeOut * outer.foot * (outer.foot - 1)) * length *
		length / 2;
	const double mixed = length * length * (inner.foot - outer.foot) / 2;
	const double acrossEdge = length * (inner.height + outer.height) / 2;
	Eigen::Matrix2d frame, response;
	frame << along, inward;
	response << alongEdge, mixed, mixed, acrossEdge;
	hinge.response = frame * response * frame.transpose();
	hinges_.push_back(hinge);
}

} // namespace developable::detail
