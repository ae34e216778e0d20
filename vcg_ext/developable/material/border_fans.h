// SPDX-License-Identifier: GPL-3.0-or-later
// border_fans.h: what it costs a pattern to turn by more than a full turn about a vertex of its border.
#pragma once

#include "rounded_penalty.h"

#include <Eigen/Core>

#include <vector>

namespace developable {

/// The tips of slits and darts, and other border vertices of a pattern where its angles add up to nearly a
/// full turn: beyond that it would overlap itself there. The angle from the first edge to the last, in the
/// plane, depends on these two edges only. The cost is Σ w p(θ − 2π) with the weight w of the triangles
/// there.
class BorderFans {
public:
	/// A share of the cost, by the coordinates of an edge's two ends.
	struct EdgeElement {
		int ends[2];
		Eigen::Vector4d gradient;
		Eigen::Matrix4d hessian; ///< both of a fan's edges together are no less than its second derivatives
	};

	BorderFans() = default;

	/// \param triangles  3 x triangles, vertices of the pattern, counterclockwise
	/// \param weights    per triangle
	/// \param flat       2 x vertices
	BorderFans(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& weights,
			   const Eigen::Matrix2Xd& flat);

	double value(const RoundedPenalty& edge, const Eigen::Matrix2Xd& flat) const;
	std::vector<EdgeElement> elements(const RoundedPenalty& edge, const Eigen::Matrix2Xd& flat) const;

	/// By how much the greatest angle is beyond a full turn, rad; 0 where none is.
	double excess(const Eigen::Matrix2Xd& flat) const;

private:
	struct Fan {
		int vertex, first, last;
		double weight;
	};

	std::vector<Fan> fans_;
};

} // namespace developable
