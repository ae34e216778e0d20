// SPDX-License-Identifier: GPL-3.0-or-later
// panel_sewing.h: all panels of a plan made developable together, time and again.
#pragma once

#include "panel_tests.h"
#include "planned_surface.h"
#include "sewn_panels.h"

#include <deque>

namespace developable::detail {

/// Sews plans together. That takes long: how often is counted, and what was seen lately is not run again.
class PanelSewing {
public:
	/// \param given   outlives this, as do the tests, which know of a stop
	/// \param limits  per patch, how far its panels may move, length
	PanelSewing(const GivenPatches& given, const std::vector<double>& limits, const CutOptions& options,
				PanelTests& tests);

	/// \param brief  see SewnRun; else as the user will do it
	SewnPanels sew(const PlannedSurface& planned, bool brief);

	/// What overlaps where a shape that was sewn before is laid flat with the cuts that there are now.
	SewnPanels look(const PlannedSurface& planned, const SewnPanels& shape) const {
		return overlapsOfShape(meshOfUser(planned), planned.surface, shape);
	}

	/// What sewing took, in units of WorkBudget.
	double work() const { return work_; }

private:
	/// As the user will have it: where a run ends hangs on the last digits of points on edges.
	TriangleMesh meshOfUser(const PlannedSurface& planned) const;

	/// On finer levels detail takes room: where a run on the surface itself comes too far, brief ones have
	/// less of it from then on.
	void lessRoomAfter(const SewnPanels& sewn, const CutSurface& surface);

	/// What the outcome depends on.
	struct Asked {
		std::vector<double> positions;
		std::vector<int> triangles, panels; // of the mesh as cut; per triangle of the surface
		bool operator==(const Asked& other) const;
	};
	struct Seen {
		Asked asked;
		bool brief;
		SewnPanels sewn;
	};
	/// Without a material, who asks briefly is served by what was seen wholly.
	bool serves(const Seen& seen, bool brief) const {
		return seen.brief == brief || (!seen.sewn.provisional && !options_.material.bounds.any());
	}
	static constexpr std::size_t mostSeen = 8; // large surfaces take room

	const GivenPatches& given_;
	const std::vector<double> limits_;
	const CutOptions options_;
	PanelTests& tests_;
	double preferredMove_; // of a run, share of the diagonal
	double briefRoom_ = 1; // share of the limits that brief runs have
	int waysLeft_ = 3;     // whole runs that may go astray, until those that do go no other way
	double work_ = 0;
	std::deque<Seen> seen_;
};

} // namespace developable::detail
