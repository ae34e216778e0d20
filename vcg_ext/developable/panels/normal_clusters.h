// SPDX-License-Identifier: GPL-3.0-or-later
// normal_clusters.h: connected clusters of triangles whose normals are alike.
#pragma once

#include "cut_surface.h"

namespace developable::detail {

struct ClusterOptions {
	/// Clusters are added until the mean square of the difference of normals is below this in each.
	double greatestDeviation = 0.15;
	int leastClusters = 1;
	int mostClusters = 100;
	int sweeps = 4; ///< of Lloyd's iteration after each round of new clusters
};

/// Variational shape approximation with planes under the metric L^{2,1} (Cohen-Steiner, Alliez and Desbrun
/// 2004): clusters grow from seeds in order of their distortion and take the mean normal as their proxy,
/// again and again. New seeds are where the distortion is greatest.
/// \param triangles  connected ones, ascending
/// \return           a label per triangle, from 0; clusters are connected
std::vector<int> normalClusters(const CutSurface& surface, const std::vector<int>& triangles,
								const ClusterOptions& options);

} // namespace developable::detail
