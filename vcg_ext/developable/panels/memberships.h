// SPDX-License-Identifier: GPL-3.0-or-later
// memberships.h: labels of triangles, diffused a little over the surface: where two of them are equal runs a
// curve that is shorter and smoother than the edges between the labels.
#pragma once

#include "sharp_features.h"

namespace developable::detail {

/// How much of each label a node has. A node is a fan of triangles round a vertex between walls: a vertex,
/// but for borders and creases between labels, along which it is several.
struct Memberships {
	Eigen::Matrix3Xi triangleNodes; ///< 3 x triangles
	int nodes = 0;
	Eigen::MatrixXd values; ///< nodes x labels, 0 to 1; rows add up to 1
};

/// How far labels spread, and what holds them.
struct Spreading {
	SharpFeatures features;
	std::vector<double> edges;               ///< per triangle, how far, in mean edge lengths of the surface
	std::vector<char> keepsToEverySharpEdge; ///< per triangle; else only to those that are alone
};

/// One implicit step of the heat equation for the indicator of each label, as in the threshold dynamics of
/// Merriman, Bence and Osher (1992) and with many labels Esedoglu and Otto (2015).
/// \param labels     per triangle, 0 to labelCount - 1
/// \param spreading  labels that meet at a sharp edge or point stay there
/// \param held       per triangle whether its vertices keep its label, or empty
Memberships memberships(const CutSurface& surface, const std::vector<int>& labels, int labelCount,
						const Spreading& spreading, const std::vector<char>& held);

/// The label of which each triangle has most, where connected parts stay connected.
std::vector<int> mostMembership(const Memberships& memberships);

} // namespace developable::detail
