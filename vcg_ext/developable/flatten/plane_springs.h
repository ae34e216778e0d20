// SPDX-License-Identifier: GPL-3.0-or-later
// plane_springs.h: the energy that flattening minimises, a spring along every edge (Eq. 7) in the plane, with
// its derivatives, and what keeps triangles from flipping.
#pragma once

#include "area_hessian.h"
#include "panel_mesh.h"
#include "plane_hessian.h"

#include <array>
#include <vector>

namespace developable::detail {

/// Σ weight·(flattened length − length)² over the edges of a panel, all weights 1 at first, plus a barrier
/// that is 0 until a triangle has lost nine tenths of its area (or less, if asked) and grows to infinity
/// where it would flip.
class PlaneSprings {
public:
	static constexpr double leastGuardedShare = 0.1;

	explicit PlaneSprings(const PanelMesh& panel);

	/// The share of its area below which a triangle is guarded by the barrier.
	double guardedShare() const { return guardedShare_; }
	void setGuardedShare(double share) { guardedShare_ = share; }

	/// Σ length², which makes energies comparable to 1.
	double scale() const;

	/// Without the barrier.
	double energy(const PlanePositions& x) const;

	/// Gives the edges weights with which their energy is, near a layout and but for a constant, that with
	/// weights 1 plus a share of it in proportion to the mean edge strain: of weight·s² and |s| a parabola
	/// touches the other at the stretch s that there is.
	/// \param share  of the energy with weights 1 at the layout
	void weighForMeanStrain(const PlanePositions& x, double share);

	/// The energy with the barrier; infinite when a triangle is flipped.
	double guardedEnergy(const PlanePositions& x) const;

	/// The gradient of guardedEnergy, 2 x vertices.
	PlanePositions gradient(const PlanePositions& x) const;

	/// An empty matrix for addHessian to fill.
	PlaneHessian hessianPattern() const { return PlaneHessian(vertexCount_, ends_); }

	/// Adds the second derivatives of guardedEnergy to a matrix.
	/// \param convex  leave out what makes it indefinite (a compressed spring pushes its ends sideways)
	void addHessian(const PlanePositions& x, bool convex, PlaneHessian& hessian) const;

	/// The longest step along a direction that flips nothing, infinite when none does: the smallest positive
	/// root of the triangles' areas, which are quadratic in the step.
	double longestStep(const PlanePositions& x, const PlanePositions& direction) const;

private:
	struct Barrier {
		double value, slope, curvature;
	};

	static constexpr double stiffness = 0.01; // of the barrier, against the springs

	double stretch(const PlanePositions& x, std::size_t edge) const {
		return (x.col(ends_[edge][1]) - x.col(ends_[edge][0])).norm() - lengths_[edge];
	}

	/// −(s − s₀)² log(s/s₀) and its derivatives: with value, slope and curvature 0 at s₀.
	Barrier barrier(double share) const;

	/// Calls visit(triangle, barrier of its share of area, gradient of its doubled area by its corners).
	template <class Visit>
	void forEachGuarded(const PlanePositions& x, Visit visit) const;

	void addGuard(int t, const Barrier& guard, const AreaGradient& area, bool convex,
				  PlaneHessian& hessian) const;

	std::vector<std::array<int, 2>> ends_;
	std::vector<double> lengths_, weights_; // per edge
	std::vector<double> restAreas_;         // doubled
	Eigen::Matrix3Xi triangles_;
	int vertexCount_;
	double guardedShare_ = leastGuardedShare;
};

} // namespace developable::detail
