// SPDX-License-Identifier: GPL-3.0-or-later
// first_panels.cpp: clusters of normals, tidied and tested.
#include "first_panels.h"

#include "memberships.h"
#include "normal_clusters.h"
#include "selected_whole.h"

#include <algorithm>
#include <limits>

namespace developable::detail {

namespace {

constexpr double smoothing = 1.5; ///< how far labels spread, in mean edge lengths

/// Labels spread a little, which takes away the teeth of their edges.
void tidyClusters(PlannedSurface& planned, const CutOptions& options) {
	const int count = planned.surface.assembly().triangleCount();
	const Spreading spreading{sharpFeatures(planned.surface, options.creaseAngle),
							  std::vector<double>(count, smoothing), std::vector<char>(count, 1)};
	const Memberships spread =
		memberships(planned.surface, planned.surface.panels(), planned.surface.panelCount(), spreading,
					keptTriangles(planned, options));
	planned.surface.relabel(
		planned.surface.withoutFragments(withSelectedWhole(planned, options, mostMembership(spread))));
}

void divideUntilFlat(PlannedSurface& planned, PanelTests& tests, const CutOptions& options) {
	std::vector<char> known;
	while (!tests.stopped()) {
		std::vector<PanelTrial> trials;
		std::vector<int> panels;
		known.resize(planned.surface.panelCount(), 0);
		for (int panel = 0; panel < planned.surface.panelCount(); ++panel) {
			const std::vector<int>& triangles = planned.surface.trianglesOf(panel);
			if (triangles.size() < 2 || known[panel])
				continue;
			trials.push_back(trialOf(planned.surface, triangles));
			panels.push_back(panel);
		}
		if (panels.empty() ||
			!tests.mayGoOn(0.05, "testing " + std::to_string(planned.surface.usedPanelCount()) + " clusters"))
			return;
		const std::vector<PanelVerdict> verdicts = tests.test(trials);
		for (std::size_t i = 0; i < panels.size() && !tests.stopped(); ++i) {
			known[panels[i]] = 1;
			if (!verdicts[i].flat)
				known[panels[i]] = !divideInTwo(planned, options, panels[i]);
		}
	}
}

} // namespace

void makeFirstPanels(PlannedSurface& planned, PanelTests& tests, const CutOptions& options,
					 double clusterDeviation) {
	ClusterOptions clusters;
	clusters.greatestDeviation = clusterDeviation;
	const int patches = planned.surface.assembly().patchCount();
	std::vector<PanelTrial> trials;
	trials.reserve(patches);
	for (int patch = 0; patch < patches; ++patch)
		trials.push_back(trialOf(planned.surface, planned.surface.trianglesOf(patch)));
	const std::vector<PanelVerdict> verdicts = tests.test(trials);
	for (int patch = 0; patch < patches; ++patch) {
		if (!verdicts[patch].flat)
			planned.surface.divide(
				patch, normalClusters(planned.surface, planned.surface.trianglesOf(patch), clusters));
	}
	tidyClusters(planned, options);
	divideUntilFlat(planned, tests, options);
}

bool divideInTwo(PlannedSurface& planned, const CutOptions& options, int panel) {
	ClusterOptions twoClusters;
	twoClusters.greatestDeviation = std::numeric_limits<double>::infinity();
	twoClusters.leastClusters = 2;
	const std::vector<int> triangles = planned.surface.trianglesOf(panel);
	const std::vector<int> halves = normalClusters(planned.surface, triangles, twoClusters);
	std::vector<int> labels(planned.surface.assembly().triangleCount(), -1);
	for (std::size_t i = 0; i < triangles.size(); ++i)
		labels[triangles[i]] = halves[i];
	labels = withSelectedWhole(planned, options, std::move(labels));
	std::vector<int> ofPanel;
	ofPanel.reserve(triangles.size());
	for (const int t : triangles)
		ofPanel.push_back(labels[t]);
	if (std::equal(ofPanel.begin() + 1, ofPanel.end(), ofPanel.begin()))
		return false;
	planned.surface.divide(panel, ofPanel);
	return true;
}

} // namespace developable::detail
