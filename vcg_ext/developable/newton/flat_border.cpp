// SPDX-License-Identifier: GPL-3.0-or-later
// flat_border.cpp: edge by edge, and what each length and angle does to what is behind it.
#include "flat_border.h"

#include "developable/geometry/geometry.h"

#include <cmath>

namespace developable::detail {

namespace {

/// A quarter of a turn to the left.
Eigen::Vector2d turned(const Eigen::Vector2d& vector) {
	return {-vector[1], vector[0]};
}

/// Adds up the gradients of lengths and angles.
class GradientSum {
public:
	GradientSum(const PatchAssembly& assembly, const Positions& positions)
		: assembly_(assembly), positions_(positions), sum_(Positions::Zero(3, assembly.placeCount())) {}

	void addLength(int halfEdge, double weight) {
		const int from = assembly_.placeAt(halfEdge), to = assembly_.placeAt(nextCorner(halfEdge));
		const Eigen::Vector3d along = (positions_.col(to) - positions_.col(from)).normalized();
		add(to, weight * along);
		add(from, -weight * along);
	}

	/// Of all angles of a copy.
	void addAngle(int copy, double weight) {
		for (int i = assembly_.cornerStart[copy]; i < assembly_.cornerStart[copy + 1]; ++i) {
			const int corner = assembly_.corners[i];
			const auto places = assembly_.trianglePlaces.col(triangleOf(corner));
			const AngleGradients gradients(triangleFrame(positions_, places));
			for (int vertex = 0; vertex < 3; ++vertex)
				add(places[vertex], weight * gradients.of(cornerInTriangle(corner), vertex));
		}
	}

	const Positions& sum() const { return sum_; }

private:
	void add(int place, const Eigen::Vector3d& gradient) {
		if (!assembly_.placeFixed[place])
			sum_.col(place) += gradient;
	}

	const PatchAssembly& assembly_;
	const Positions& positions_;
	Positions sum_;
};

} // namespace

std::vector<std::vector<int>> bordersOfDisks(const PatchAssembly& assembly) {
	std::vector<char> mixed(assembly.patchCount(), 0);
	std::vector<int> leaving(assembly.copyCount(), -1), first(assembly.patchCount(), -1);
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if (assembly.triangleReversed[t])
			mixed[assembly.patchOfTriangle[t]] = 1;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
		if (assembly.across(h) < 0) {
			leaving[assembly.copyAt(h)] = h;
			first[assembly.patchOfTriangle[triangleOf(h)]] = h;
		}
	std::vector<std::vector<int>> borders(assembly.patchCount());
	for (int patch = 0; patch < assembly.patchCount(); ++patch) {
		const Patch& shape = assembly.patches[patch];
		if (mixed[patch] || shape.closed() || shape.eulerCharacteristic() != 1)
			continue;
		std::vector<int>& border = borders[patch];
		for (int h = first[patch]; static_cast<int>(border.size()) < shape.boundaryEdges;
			 h = leaving[assembly.copyAt(nextCorner(h))])
			border.push_back(h);
	}
	return borders;
}

FlatBorder::FlatBorder(const PatchAssembly& assembly, const Positions& positions,
					   const Eigen::VectorXd& angles, const std::vector<int>& halfEdges)
	: points_(1, Eigen::Vector2d::Zero()) {
	double heading = 0;
	for (std::size_t i = 0; i < halfEdges.size(); ++i) {
		const int h = halfEdges[i];
		if (i > 0)
			heading += pi - angles[assembly.copyAt(h)];
		directions_.emplace_back(std::cos(heading), std::sin(heading));
		const double length =
			(positions.col(assembly.placeAt(nextCorner(h))) - positions.col(assembly.placeAt(h))).norm();
		points_.push_back(points_.back() + length * directions_.back());
	}
}

/// What the patch has left of its curvature keeps the border from closing, by next to nothing.
Eigen::Matrix2Xd FlatBorder::closed() const {
	const auto count = Eigen::Index(directions_.size());
	const Eigen::Vector2d open = (points_.back() - points_.front()) / double(count);
	Eigen::Matrix2Xd result(2, count);
	for (Eigen::Index i = 0; i < count; ++i)
		result.col(i) = points_[i] - double(i) * open;
	return result;
}

std::vector<std::array<int, 2>> crossingsOf(const Eigen::Matrix2Xd& border) {
	const int count = static_cast<int>(border.cols());
	std::vector<BoundarySegment> segments;
	segments.reserve(count);
	for (int i = 0; i < count; ++i)
		segments.push_back({i, (i + 1) % count, 0, i});
	return crossingPieces(border, std::move(segments), 1).front().itself;
}

Positions gapGradient(const PatchAssembly& assembly, const Positions& positions, const BorderGap& gap,
					  const FlatBorder& border) {
	GradientSum gradient(assembly, positions);
	const Eigen::Vector2d right = border.rightOf(gap.edge);
	const bool ahead = gap.point > gap.edge;
	const double sign = ahead ? 1 : -1;
	// The edge stays where it is; between the two are these edges, and the points at which these turn.
	const int begin = ahead ? gap.edge + 1 : gap.point, end = ahead ? gap.point : gap.edge;
	const auto turnBehind = [&](int point) {
		const Eigen::Vector2d arm = border.points()[gap.point] - border.points()[point];
		gradient.addAngle(assembly.copyAt(gap.halfEdges[point]), -sign * right.dot(turned(arm)));
	};
	for (int edge = begin; edge < end; ++edge) {
		gradient.addLength(gap.halfEdges[edge], sign * right.dot(border.direction(edge)));
		turnBehind(ahead ? edge : edge + 1);
	}
	return gradient.sum();
}

} // namespace developable::detail
