// SPDX-License-Identifier: GPL-3.0-or-later
// crease_regions.h: what creases enclose, and whether it is developable as it is.
#pragma once

#include "seam_chains.h"
#include "sharp_features.h"

namespace developable::detail {

/// Labels of what edges that are sharp and alone, and cuts, enclose.
/// \param triangles  of one or more panels
/// \return           per triangle of those
std::vector<int> regionsBetween(const SharpFeatures& features, const CutSurface& surface,
								const std::vector<int>& triangles);

/// Whether no panel has an angle defect inside, but for sharp points, to which slits can lead.
bool isDevelopable(const CutSurface& surface);

/// Whether more than half of a seam lies on a crease.
bool liesOnCrease(const SeamChain& chain, const CutSurface& surface, const SharpFeatures& features);

} // namespace developable::detail
