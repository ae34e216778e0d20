// SPDX-License-Identifier: GPL-3.0-or-later
// panel_tests.h: tests of panels of a cut surface, as they are or as they would be, several at once.
#pragma once

#include "cut_surface.h"
#include "panel_test.h"

#include <algorithm>
#include <atomic>
#include <map>

namespace developable::detail {

/// A panel that might be.
struct PanelTrial {
	TriangleMesh panel;
	int patch = 0;
};

/// \param triangles  ascending, of one patch
PanelTrial trialOf(const CutSurface& surface, const std::vector<int>& triangles);

/// What meets at some half edges, without the cuts there. The surface is the same afterwards.
PanelTrial trialAcross(CutSurface& surface, const std::vector<int>& halfEdges);

class PanelTests {
public:
	/// \param maxDisplacement  per patch of the surface, length
	PanelTests(std::vector<double> maxDisplacement, const PanelMaterial& material, Progress progress);

	/// Within what a patch's panels have to stay, by themselves: sewn together they will move a little more.
	PanelLimits limitsOf(int patch) const;
	/// All limits are so many times what they were at first.
	void scaleLimits(double factor);

	std::vector<PanelVerdict> test(const std::vector<PanelTrial>& trials);
	/// Whether all are panels; not when the user asks for a stop.
	bool areAllPanels(const std::vector<PanelTrial>& trials);

	/// Says how far the work is. \return false when the user asked for a stop, now or before
	bool mayGoOn(double fractionDone, const std::string& message);
	bool stopped() const { return stopped_; }

	/// How much has been tested, in triangles: what time may be measured by and be the same on every run.
	double work() const { return work_; }
	/// What it may come to, when a stage may do so much beside what was done before; a little it may always
	/// do.
	double workWith(double share) const { return work_ + std::max(share * work_, smallWork); }

private:
	static constexpr double smallWork = 3e5; // triangles, which take seconds

	const std::vector<double> maxDisplacement_;
	const PanelMaterial material_;
	const Progress progress_;
	double scale_ = 1;
	double work_ = 0;
	std::map<std::pair<std::vector<double>, std::vector<int>>, PanelVerdict> known_; // by vertices, triangles
	std::atomic<bool> stopped_{false};
	double fractionDone_ = 0;
	std::string message_;
};

} // namespace developable::detail
