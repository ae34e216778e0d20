// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_levels.h: one part on all its levels, or on the finest alone.
#pragma once

#include "bounded_run.h"

namespace developable::detail {

struct LevelOutcome {
	BoundedEnding ending = BoundedEnding::Stuck;
	int iterations = 0;
	Positions positions;
};

/// Runs from a shape to the nearest one within the bounds.
class BoundedLevels {
public:
	/// \param farthest  how far places may go, length; positive
	BoundedLevels(const BoundedStrainOptions& options, double farthest, const BendingLimit& bending)
		: options_(options), farthest_(farthest), bending_(bending) {}

	/// From bounds that are soft. Large parts are first solved with a quarter of their places, in the same
	/// way; the displacement found, carried over smoothly, is where the fine one starts, with hard bounds.
	LevelOutcome solve(const PatchAssembly& assembly, const Positions& start, const Progress& progress) const;

	/// With bounds that are less soft, so that the result is in the neighbourhood of a start within them.
	/// \param stiffness  κ to begin with
	LevelOutcome continueFrom(const PatchAssembly& assembly, const Positions& start, double stiffness,
							  const Progress& progress) const;

private:
	LevelOutcome refine(const PatchAssembly& assembly, const Positions& start, const PartialAssembly& coarse,
						const Progress& progress) const;

	const BoundedStrainOptions& options_;
	const double farthest_;
	const BendingLimit bending_;
};

} // namespace developable::detail
