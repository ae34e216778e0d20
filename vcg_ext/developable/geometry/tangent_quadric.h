// SPDX-License-Identifier: GPL-3.0-or-later
// tangent_quadric.h: the quadric over the tangent plane of a vertex copy that fits its neighbours best.
#pragma once

#include "second_rings.h"

#include <functional>
#include <vector>

namespace developable::detail {

/// Fits a x² + b xy + c y² + d x + e y to values at the second ring of a copy, relative to that at itself, x
/// and y being coordinates in its tangent plane in units of the ring's reach; of several such quadrics the
/// smallest.
class TangentQuadric {
public:
	static constexpr int unknowns = 5; ///< a to e

	/// \param ring  the places round it
	TangentQuadric(const Positions& positions, int place, const Eigen::Vector3d& normal,
				   const std::vector<int>& ring);

	double reach() const { return reach_; } ///< length
	/// Of the ring over the plane, in units of the reach.
	const Eigen::RowVectorXd& heights() const { return heights_; }

	/// \param values  at the ring
	Eigen::Matrix<double, unknowns, 1> fitted(const Eigen::RowVectorXd& values) const;
	/// unknowns x ring: what a unit of each value adds to the quadric.
	Eigen::Matrix<double, unknowns, Eigen::Dynamic> solution() const;

private:
	double reach_ = 0;
	Eigen::RowVectorXd heights_;
	Eigen::Matrix<double, unknowns, Eigen::Dynamic> design_;
	Eigen::Matrix<double, unknowns, unknowns> pseudoInverse_; // of design · designᵀ
};

/// Of a copy, the places round it, and the quadric there.
using TangentQuadricVisitor = std::function<void(int, const std::vector<int>&, const TangentQuadric&)>;

/// The quadric of every copy that has enough neighbours and a normal.
void visitTangentQuadrics(const PatchAssembly& assembly, const Positions& positions,
						  const TangentQuadricVisitor& visit);

} // namespace developable::detail
