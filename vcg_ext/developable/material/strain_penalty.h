// SPDX-License-Identifier: GPL-3.0-or-later
// strain_penalty.h: what it costs to leave the bounds, with its derivatives by both shape and pattern.
#pragma once

#include "border_fans.h"
#include "rounded_penalty.h"
#include "strain_bounds.h"
#include "triangle_strain.h"

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable {

/// The triangles of a shape and of its pattern, corner by corner; in the plane they run counterclockwise.
struct StrainedTriangles {
	Eigen::Matrix3Xi shaped; ///< 3 x triangles, columns of 3D positions
	Eigen::Matrix3Xi flat;   ///< 3 x triangles, columns of plane positions
	Eigen::VectorXd weights; ///< per triangle, its share of the area
	std::vector<double>
		grain;       ///< per triangle, the direction of the warp in the plane, rad; empty: undirected
	BorderFans fans; ///< where the pattern might overlap itself; none: that is not looked at

	int count() const { return static_cast<int>(flat.cols()); }
};

/// The cost Ψ of strains e = log |F v| along unit vectors v of the pattern: those of the singular values for
/// what is bounded in every direction, and warp, weft and both diagonals for what is not. With bounds l ≤ e ≤
/// h and a triangle's weight w,
///     Ψ = Σ w (γ/2 e² + p(e − h) + p(l − e))
/// with the RoundedPenalty p, and the cost of the BorderFans. The little elastic energy makes the pattern
/// unique where no bound is touched. Second derivatives count that principal directions turn, and leave out
/// what would make them indefinite.
class StrainPenalty {
public:
	/// Derivatives by so many coordinates.
	template <int size>
	struct Derivatives {
		Eigen::Matrix<double, size, 1> gradient = Eigen::Matrix<double, size, 1>::Zero();
		Eigen::Matrix<double, size, size> hessian = Eigen::Matrix<double, size, size>::Zero();
	};
	/// By the nine coordinates of the shape's corners, then by the six of the pattern's.
	using Element = Derivatives<15>;
	/// By the six of the pattern's corners.
	using FlatElement = Derivatives<6>;

	/// \param elasticity  γ
	StrainPenalty(StrainedTriangles triangles, const StrainBounds& bounds, double elasticity);

	const StrainedTriangles& triangles() const { return triangles_; }
	/// \param grain  per triangle, rad; not looked at where the bounds are not directed
	void setGrain(std::vector<double> grain);

	/// From now on the pattern's border counts, too.
	/// \param flat  the pattern as it is at first
	void watchBorder(const Eigen::Matrix2Xd& flat) {
		triangles_.fans = BorderFans(triangles_.flat, triangles_.weights, flat);
	}

	/// \param stiffness  κ
	/// \param width      δ, a strain
	void harden(double stiffness, double width) { edge_ = {stiffness, width}; }

	/// p as it is now.
	const RoundedPenalty& edge() const { return edge_; }

	/// Infinite where a triangle of the pattern is flipped.
	double value(const Positions& shaped, const Eigen::Matrix2Xd& flat) const;

	/// Of one triangle. The pattern must not be flipped there.
	Element element(int triangle, const Positions& shaped, const Eigen::Matrix2Xd& flat) const;
	FlatElement flatElement(int triangle, const Positions& shaped, const Eigen::Matrix2Xd& flat) const;

	/// What border fans add.
	std::vector<BorderFans::EdgeElement> borderElements(const Eigen::Matrix2Xd& flat) const {
		return triangles_.fans.elements(edge_, flat);
	}

	/// By how much each triangle is beyond its bounds, as a strain; 0 within.
	Eigen::VectorXd violations(const Positions& shaped, const Eigen::Matrix2Xd& flat) const;

	/// The greatest of these, and of what the border is beyond its own bound.
	double greatestViolation(const Positions& shaped, const Eigen::Matrix2Xd& flat) const {
		return std::max(violations(shaped, flat).maxCoeff(), triangles_.fans.excess(flat));
	}

private:
	struct Signs {
		bool stretch, compression;
	};
	/// Of strains along one direction. Without a bound it is infinite.
	struct Limits {
		double least, greatest; // l, h
		double elasticity;      // γ's share

		bool any() const { return std::isfinite(least) || std::isfinite(greatest); }
	};
	struct Direction {
		Eigen::Vector2d vector;
		const Limits* limits;
	};
	struct Directions {
		Direction items[6];
		int count = 0;

		void add(const Eigen::Vector2d& vector, const Limits& limits) { items[count++] = {vector, &limits}; }
		const Direction* begin() const { return items; }
		const Direction* end() const { return items + count; }
	};
	struct Slope {
		double first, second; // of the cost by e
	};

	/// Which sign's bounds differ with the direction.
	static Signs differs(const StrainBounds& bounds);
	/// \param bounded  which of the bounds count
	static Limits limitsOf(const DirectionBounds& bounds, const Signs& bounded, double elasticity);

	template <int size>
	Derivatives<size> derivatives(int triangle, const Positions& shaped, const Eigen::Matrix2Xd& flat) const;
	TriangleStrain strain(int triangle, const Positions& shaped, const Eigen::Matrix2Xd& flat) const;
	Directions directions(int triangle, const TriangleStrain& strain) const;
	double cost(const TriangleStrain& strain, const Directions& directions) const;
	Slope slope(const Limits& limits, double strain) const;

	StrainedTriangles triangles_;
	std::vector<Eigen::Vector2d> warp_; // per triangle, in the plane
	const bool directed_;               // whether bounds of either sign differ with the direction
	const Limits ofPrincipal_, ofWarp_, ofWeft_, ofBias_;
	RoundedPenalty edge_;
};

/// The strains of every triangle. \return 2 x triangles: σ1, σ2
Eigen::Matrix2Xd principalStrains(const StrainedTriangles& triangles, const Positions& shaped,
								  const Eigen::Matrix2Xd& flat);

} // namespace developable
