// SPDX-License-Identifier: GPL-3.0-or-later
// held_grain.h: pieces of a pattern that do not turn against their grain while they change.
#pragma once

#include "developable/material/material.h"

#include <array>
#include <vector>

namespace developable {

/// Where bounds differ with the direction, what they cost depends on how a pattern lies against its grain,
/// but not on how it lies in the plane. So the grain keeps its direction in the plane, and pieces are turned
/// to it.
class HeldGrain {
public:
	struct Piece {
		StrainedTriangles triangles;
		std::array<int, 2> longestSide = {-1, -1}; ///< see grainDirection
	};

	/// No grain: nothing is held.
	HeldGrain() = default;

	/// \param shaped, flat  where the grain is taken from
	HeldGrain(std::vector<Piece> pieces, const Grain& grain, const Positions& shaped,
			  const Eigen::Matrix2Xd& flat);

	/// Per piece, rad.
	const std::vector<double>& angles() const { return angles_; }

	/// Turns every piece until its grain runs as at first.
	void align(const Positions& shaped, Eigen::Matrix2Xd& flat) const;

	/// How fast the grain of each piece turns: its derivatives by the coordinates of the shape and then those
	/// of the pattern, or by those of the pattern alone. \return unknowns x pieces; none without a grain
	Eigen::MatrixXd slopes(const Positions& shaped, const Eigen::Matrix2Xd& flat, bool byShape) const;

private:
	std::vector<Piece> pieces_;
	std::vector<std::vector<int>> vertices_; // of each piece
	std::vector<double> angles_;
	Grain grain_ = Grain::LongestSeam;
};

/// The p of least gᵀp + ½ pᵀHp with slopesᵀ p = 0.
/// \param solve  v ↦ H⁻¹ v
template <class Solve>
Eigen::VectorXd heldDirection(const Solve& solve, const Eigen::VectorXd& gradient,
							  const Eigen::MatrixXd& slopes) {
	Eigen::VectorXd free = solve(Eigen::VectorXd(-gradient));
	if (slopes.cols() == 0)
		return free;
	Eigen::MatrixXd answers(slopes.rows(), slopes.cols());
	for (Eigen::Index i = 0; i < slopes.cols(); ++i)
		answers.col(i) = solve(Eigen::VectorXd(slopes.col(i)));
	return free - answers * (slopes.transpose() * answers).ldlt().solve(slopes.transpose() * free);
}

} // namespace developable
