// SPDX-License-Identifier: GPL-3.0-or-later
// plane_springs.h: the energy that flattening minimises, a spring along every edge (Eq. 7) in the plane, with
// its derivatives, and what keeps triangles from flipping.
#pragma once

#include "flat_start.h"
#include "plane_hessian.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace developable::detail {

/// Σ weight·(flattened length − length)² over the edges of a panel, all weights 1 at first, plus a barrier
/// that is 0 until a triangle has lost nine tenths of its area (or less, if asked) and grows to infinity
/// where it would flip.
class PlaneSprings {
public:
	static constexpr double leastGuardedShare = 0.1;

	explicit PlaneSprings(const PanelMesh& panel)
		: triangles_(panel.triangles), vertexCount_(panel.vertexCount()) {
		for (int h = 0; h < panel.halfEdgeCount(); ++h)
			if (panel.firstOfEdge(h)) {
				ends_.push_back({panel.start(h), panel.end(h)});
				lengths_.push_back(panel.length(h));
			}
		weights_.assign(lengths_.size(), 1);
		restAreas_.resize(panel.triangleCount());
		for (int t = 0; t < panel.triangleCount(); ++t) {
			const auto triangle = triangles_.col(t);
			restAreas_[t] = TriangleFrame(panel.positions.col(triangle[0]), panel.positions.col(triangle[1]),
										  panel.positions.col(triangle[2]))
								.normal.norm();
		}
	}

	/// The share of its area below which a triangle is guarded by the barrier.
	double guardedShare() const { return guardedShare_; }
	void setGuardedShare(double share) { guardedShare_ = share; }

	/// Σ length², which makes energies comparable to 1.
	double scale() const {
		return Eigen::Map<const Eigen::VectorXd>(lengths_.data(), lengths_.size()).squaredNorm();
	}

	double energy(const PlanePositions& x) const {
		double sum = 0;
		for (std::size_t edge = 0; edge < ends_.size(); ++edge)
			sum += weights_[edge] * stretch(x, edge) * stretch(x, edge);
		return sum;
	}

	/// Gives the edges weights with which their energy is, near a layout and but for a constant, that with
	/// weights 1 plus a share of it in proportion to the mean edge strain: of weight·s² and |s| a parabola
	/// touches the other at the stretch s that there is.
	/// \param share  of the energy with weights 1 at the layout
	void weighForMeanStrain(const PlanePositions& x, double share) {
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

	/// The energy with the barrier; infinite when a triangle is flipped.
	double guardedEnergy(const PlanePositions& x) const {
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

	/// The gradient of guardedEnergy, 2 x vertices.
	PlanePositions gradient(const PlanePositions& x) const {
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

	/// An empty matrix for hessian() to fill.
	PlaneHessian hessianPattern() const { return PlaneHessian(vertexCount_, ends_); }

	/// Adds the second derivatives of guardedEnergy to a matrix.
	/// \param convex  leave out what makes it indefinite (a compressed spring pushes its ends sideways)
	void addHessian(const PlanePositions& x, bool convex, PlaneHessian& hessian) const {
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

	/// The longest step along a direction that flips nothing, infinite when none does: the smallest positive
	/// root of the triangles' areas, which are quadratic in the step.
	double longestStep(const PlanePositions& x, const PlanePositions& direction) const {
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

private:
	using AreaGradient = Eigen::Matrix<double, 6, 1>;

	struct Barrier {
		double value, slope, curvature;
	};

	static constexpr double stiffness = 0.01; // of the barrier, against the springs

	double stretch(const PlanePositions& x, std::size_t edge) const {
		return (x.col(ends_[edge][1]) - x.col(ends_[edge][0])).norm() - lengths_[edge];
	}

	/// −(s − s₀)² log(s/s₀) and its derivatives: with value, slope and curvature 0 at s₀.
	Barrier barrier(double share) const {
		const double lost = share - guardedShare_, logarithm = std::log(share / guardedShare_);
		return {-lost * lost * logarithm, -2 * lost * logarithm - lost * lost / share,
				-2 * logarithm - 4 * lost / share + lost * lost / (share * share)};
	}

	/// Calls visit(triangle, barrier of its share of area, gradient of its doubled area by its corners).
	template <class Visit>
	void forEachGuarded(const PlanePositions& x, Visit visit) const {
		for (int t = 0; t < triangles_.cols(); ++t) {
			const double share = doubleArea(x, triangles_.col(t)) / restAreas_[t];
			if (!(share < guardedShare_))
				continue;
			AreaGradient area;
			for (int corner = 0; corner < 3; ++corner) {
				const Eigen::Vector2d opposite =
					x.col(triangles_((corner + 2) % 3, t)) - x.col(triangles_((corner + 1) % 3, t));
				area.segment<2>(2 * corner) << -opposite[1], opposite[0];
			}
			visit(t, barrier(share), area);
		}
	}

	void addGuard(int t, const Barrier& guard, const AreaGradient& area, bool convex,
				  PlaneHessian& hessian) const {
		using Block = Eigen::Matrix<double, 6, 6>;
		Block second = Block::Zero(); // of the doubled area
		for (int corner = 0; corner < 3; ++corner) {
			const int a = 2 * corner, b = 2 * ((corner + 1) % 3);
			second(a, b + 1) = second(b + 1, a) = 1;
			second(a + 1, b) = second(b, a + 1) = -1;
		}
		Block block =
			stiffness * (guard.curvature / restAreas_[t] * area * area.transpose() + guard.slope * second);
		if (convex) {
			const Eigen::SelfAdjointEigenSolver<Block> eigen(block);
			block = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
					eigen.eigenvectors().transpose();
		}
		for (int row = 0; row < 3; ++row)
			for (int column = 0; column < 3; ++column) {
				const int i = triangles_(row, t), j = triangles_(column, t);
				if (i >= j)
					hessian.add(i, j, block.block<2, 2>(2 * row, 2 * column));
			}
	}

	std::vector<std::array<int, 2>> ends_;
	std::vector<double> lengths_, weights_; // per edge
	std::vector<double> restAreas_;         // doubled
	Eigen::Matrix3Xi triangles_;
	int vertexCount_;
	double guardedShare_ = leastGuardedShare;
};

} // namespace developable::detail
