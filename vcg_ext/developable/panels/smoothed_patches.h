// SPDX-License-Identifier: GPL-3.0-or-later
// smoothed_patches.h: a copy of a surface without noise and fine detail, to look for its panels on.
#pragma once

#include "planned_surface.h"

#include <optional>

namespace developable::detail {

/// Where seams should run is a matter of what is left without detail.
class SmoothedPatches {
public:
	/// \param given   outlives this
	/// \param limits  per patch, how far its panels may move, length
	SmoothedPatches(const GivenPatches& given, const std::vector<double>& limits);

	/// Whether there is any; the rest is for where there is.
	bool hadDetail() const { return smoothed_.has_value(); }

	/// The same triangles; every copy of a vertex is a vertex here, and every triangle a face.
	const GivenPatches& patches() const { return smooth_; }

	/// How far panels may move here: what was smoothed away takes room, too. Per patch.
	std::vector<double> limits() const;

	/// Panels found here on what was given, whose points they have to the last bit.
	PlannedSurface carriedBack(const PlannedSurface& planned) const;

private:
	const GivenPatches& given_;
	const std::vector<double> limits_;
	PatchAssembly assembly_; // of what was given
	std::optional<PatchAssembly> smoothed_;
	GivenPatches smooth_;
};

} // namespace developable::detail
