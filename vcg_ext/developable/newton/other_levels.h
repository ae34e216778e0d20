// SPDX-License-Identifier: GPL-3.0-or-later
// other_levels.h: sewn panels from smaller coarse levels, where the usual one leads too far.
#pragma once

#include "newton_strategy.h"

#include "developable/mesh/mesh.h"

#include <deque>

namespace developable::detail {

/// Whether a part has panels that are sewn together, free to move, and is small enough to be solved more than
/// once, but not too small for a coarser level.
bool mayTryOtherLevels(const PatchAssembly& part, const NewtonTuning& tuning);

/// Panels that are sewn together pull at each other, and where a run ends hangs on the triangles of its
/// coarsest level and on the detail that finer ones add: what one leads astray a smaller one, or one near a
/// fair shape without that detail, may lead to a developable shape within how far a place had better move.
/// Other ways are tried one after the other until one does. Where other threads are at hand the next ones
/// begin before it is known that they are needed; what comes of it is the same to the last bit.
class OtherLevels {
public:
	/// None, where they may not be tried.
	/// \param part, start  outlive this
	/// \param usual        the strategy of the way before
	OtherLevels(const PatchAssembly& part, const Positions& start, const NewtonStrategy& usual);

	/// Whether there are any.
	bool any() const { return !ways_.empty(); }

	/// The progress of the usual way, beside which the first of these begins when it takes long.
	/// \param budget  of that way; outlives its progress
	Progress beside(const WorkBudget& budget, const Progress& progress);

	/// Nothing is done where the usual way has led near enough.
	/// \param outcome  of the usual way; becomes what is nearer
	void tryAll(NewtonOutcome& outcome, const Progress& progress);

private:
	struct Way {
		Way(const PatchAssembly& part, const Positions& start, NewtonStrategy ofWay)
			: strategy(std::move(ofWay)), task([this, &part, &start](const Progress& progress) {
				  outcome = strategy.solve(part, start, progress);
			  }) {}

		const NewtonStrategy strategy;
		NewtonOutcome outcome;
		TaskAhead task; // the last: it ends before what it works on
	};

	/// So many ways from one on, on other threads.
	void begin(std::size_t first, int count);
	NewtonOutcome outcomeOf(Way& way, const Progress& progress) const;

	const PatchAssembly& part_;
	const Positions& start_;
	const NewtonTuning tuning_;
	std::deque<Way> ways_;
};

} // namespace developable::detail
