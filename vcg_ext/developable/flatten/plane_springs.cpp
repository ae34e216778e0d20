// SPDX-License-Identifier: GPL-3.0-or-later
// plane_springs.cpp: sums over the springs and over the triangles that the barrier guards.
#include "plane_springs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace developable::detail {

PlaneSprings::PlaneSprings(const PanelMesh& panel)
	: triangles_(panel.triangles), vertexCount_(panel.vertexCount()) {
	for (int h = 0; h < panel.halfEdgeCount(); ++h)
		if (panel.firstOfEdge(h)) {
			ends_.push_back({panel.start(h), panel.end(h)});
			lengths_.push_back(panel.length(h));
		}
	weights_.assign(lengths_.size(), 1);
	restAreas_.resize(panel.triangleCount());
	for (int t = 0; t < panel.triangleCount(); ++t)
		restAreas_[t] = panel.frame(t).normal.norm();
}

double PlaneSprings::scale() const {
	return Eigen::Map<const Eigen::VectorXd>(lengths_.data(), lengths_.size()).squaredNorm();
}

double PlaneSprings::energy(const PlanePositions& x) const {
	double sum = 0;
	for (std::size_t edge = 0; edge < ends_.size(); ++edge)
		sum += weights_[edge] * stretch(x, edge) * stretch(x, edge);
	return sum;
}

void PlaneSprings::weighForMeanStrain(const PlanePositions& x, double share) {
	weights_.assign(lengths_.size(), 1);
	double strains = 0;
	for (std::size_t edge = 0; edge < ends_.size(); ++edge)
		strains += std::abs(stretch(x, edge)) / lengths_[edge];
	if (strains == 0)
		return;
	const double least = 0.01 * strains / static_cast<double>(ends_.size()),
				 factor = share * energy(x) / (2 * strains);
	for (std::size_t edge = 0; edge < ends_.size(); ++edge) {
		const double strain = std::max(std::abs(stretch(x, edge)) / lengths_[edge], least);
		weights_[edge] += factor / (strain * lengths_[edge] * lengths_[edge]);
	}
}

double PlaneSprings::guardedEnergy(const PlanePositions& x) const {
	double sum = 0;
	for (int t = 0; t < triangles_.cols(); ++t) {
		const double share = doubleArea(x, triangles_.col(t)) / restAreas_[t];
		if (!(share > 0))
			return std::numeric_limits<double>::infinity();
		if (share < guardedShare_)
			sum += stiffness * restAreas_[t] * barrier(share).value;
	}
	return energy(x) + sum;
}

PlaneSprings::Barrier PlaneSprings::barrier(double share) const {
	const double lost = share - guardedShare_, logarithm = std::log(share / guardedShare_);
	return {-lost * lost * logarithm, -2 * lost * logarithm - lost * lost / share,
			-2 * logarithm - 4 * lost / share + lost * lost / (share * share)};
}

template <class Visit>
void PlaneSprings::forEachGuarded(const PlanePositions& x, Visit visit) const {
	for (int t = 0; t < triangles_.cols(); ++t) {
		const double share = doubleArea(x, triangles_.col(t)) / restAreas_[t];
		if (!(share < guardedShare_))
			continue;
		AreaGradient area;
		for (int corner = 0; corner < 3; ++corner) {
			const Eigen::Vector2d opposite =
				x.col(triangles_(previousCorner(corner), t)) - x.col(triangles_(nextCorner(corner), t));
			area.segment<2>(2 * corner) << -opposite[1], opposite[0];
		}
		visit(t, barrier(share), area);
	}
}

PlanePositions PlaneSprings::gradient(const PlanePositions& x) const {
	PlanePositions result = PlanePositions::Zero(2, x.cols());
	for (std::size_t edge = 0; edge < ends_.size(); ++edge) {
		const Eigen::Vector2d along = x.col(ends_[edge][0]) - x.col(ends_[edge][1]);
		const Eigen::Vector2d pull = 2 * weights_[edge] * (1 - lengths_[edge] / along.norm()) * along;
		result.col(ends_[edge][0]) += pull;
		result.col(ends_[edge][1]) -= pull;
	}
	forEachGuarded(x, [&](int t, const Barrier& guard, const AreaGradient& area) {
		for (int corner = 0; corner < 3; ++corner)
			result.col(triangles_(corner, t)) += stiffness * guard.slope * area.segment<2>(2 * corner);
	});
	return result;
}

void PlaneSprings::addHessian(const PlanePositions& x, bool convex, PlaneHessian& hessian) const {
	for (std::size_t edge = 0; edge < ends_.size(); ++edge) {
		const Eigen::Vector2d along = x.col(ends_[edge][0]) - x.col(ends_[edge][1]);
		const double squaredLength = along.squaredNorm();
		double sideways = 1 - lengths_[edge] / std::sqrt(squaredLength);
		if (convex)
			sideways = std::max(sideways, 0.0);
		const Eigen::Matrix2d block = 2 * weights_[edge] *
									  (sideways * Eigen::Matrix2d::Identity() +
									   (1 - sideways) / squaredLength * along * along.transpose());
		hessian.add(ends_[edge][0], ends_[edge][0], block);
		hessian.add(ends_[edge][1], ends_[edge][1], block);
		hessian.add(ends_[edge][0], ends_[edge][1], -block);
	}
	forEachGuarded(x, [&](int t, const Barrier& guard, const AreaGradient& area) {
		addGuard(t, guard, area, convex, hessian);
	});
}

void PlaneSprings::addGuard(int t, const Barrier& guard, const AreaGradient& area, bool convex,
							PlaneHessian& hessian) const {
	const double slope = stiffness * guard.slope, curvature = stiffness * guard.curvature / restAreas_[t];
	const AreaHessian block =
		convex ? convexAreaHessian(area, slope, curvature) : areaHessian(area, slope, curvature);
	for (int row = 0; row < 3; ++row)
		for (int column = 0; column < 3; ++column) {
			const int i = triangles_(row, t), j = triangles_(column, t);
			if (i >= j)
				hessian.add(i, j, block.block<2, 2>(2 * row, 2 * column));
		}
}

double PlaneSprings::longestStep(const PlanePositions& x, const PlanePositions& direction) const {
	double longest = std::numeric_limits<double>::infinity();
	for (const auto& triangle : triangles_.colwise()) {
		const Eigen::Vector2d a = x.col(triangle[1]) - x.col(triangle[0]);
		const Eigen::Vector2d b = x.col(triangle[2]) - x.col(triangle[0]);
		const Eigen::Vector2d da = direction.col(triangle[1]) - direction.col(triangle[0]);
		const Eigen::Vector2d db = direction.col(triangle[2]) - direction.col(triangle[0]);
		const double constant = a[0] * b[1] - a[1] * b[0];
		const double linear = a[0] * db[1] - a[1] * db[0] + da[0] * b[1] - da[1] * b[0];
		const double square = da[0] * db[1] - da[1] * db[0];
		const double discriminant = linear * linear - 4 * square * constant;
		if (discriminant < 0)
			continue;
		// The form without cancellation; the other root is the larger one, or negative.
		const double root = 2 * constant / (-linear + std::sqrt(discriminant));
		if (root > 0)
			longest = std::min(longest, root);
	}
	return longest;
}

} // namespace developable::detail
