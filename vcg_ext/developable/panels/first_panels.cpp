// SPDX-License-Identifier: GPL-3.0-or-later
// first_panels.cpp: clusters of normals, tidied and tested.
#include "first_panels.h"

#include "crease_regions.h"
#include "memberships.h"
#include "normal_clusters.h"
#include "selected_whole.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace developable::detail {

namespace {

constexpr double smoothing = 1.5; ///< how far labels spread, in mean edge lengths

/// Labels spread a little, which takes away the teeth of their edges.
void tidyClusters(PlannedSurface& planned, const SharpFeatures& features, const CutOptions& options) {
	const int count = planned.surface.assembly().triangleCount();
	const Spreading spreading{features, std::vector<double>(count, smoothing), std::vector<char>(count, 1)};
	const Memberships spread =
		memberships(planned.surface, planned.surface.panels(), planned.surface.panelCount(), spreading,
					keptTriangles(planned, options));
	planned.surface.relabel(
		planned.surface.withoutFragments(withSelectedWhole(planned, options, mostMembership(spread))));
}

/// On all panels.
std::vector<PanelVerdict> verdictsOn(const CutSurface& surface, PanelTests& tests) {
	std::vector<PanelTrial> trials;
	trials.reserve(surface.panelCount());
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		trials.push_back(trialOf(surface, surface.trianglesOf(panel)));
	return tests.test(trials);
}

/// Every panel that is not flat, by some labels of its triangles.
void divideWhatIsNotFlat(PlannedSurface& planned, PanelTests& tests,
						 const std::function<std::vector<int>(const std::vector<int>&)>& labelsOf) {
	const std::vector<PanelVerdict> verdicts = verdictsOn(planned.surface, tests);
	for (int panel = 0; panel < static_cast<int>(verdicts.size()) && !tests.stopped(); ++panel)
		if (!verdicts[panel].flat)
			planned.surface.divide(panel, labelsOf(planned.surface.trianglesOf(panel)));
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

constexpr int mostPieces = 500; ///< that anybody would fold and glue

/// As if each were alone.
SharpFeatures everySharpEdge(const CutSurface& surface, double creaseAngle) {
	SharpFeatures features = sharpFeatures(surface, creaseAngle);
	for (SharpFeatures::Kind& kind : features.edges)
		kind = kind == SharpFeatures::None ? kind : SharpFeatures::Alone;
	return features;
}

void divideBetween(const SharpFeatures& features, PlannedSurface& planned, const CutOptions& options) {
	std::vector<int> all(planned.surface.assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	planned.surface.relabel(
		withSelectedWhole(planned, options, regionsBetween(features, planned.surface, all)));
}

/// No edge is sharp in a patch that is a panel already.
void keepPanelsWhole(const CutSurface& surface, PanelTests& tests, SharpFeatures& features) {
	const CutSurface whole(surface.assembly());
	const std::vector<PanelVerdict> verdicts = verdictsOn(whole, tests);
	for (int h = 0; h < static_cast<int>(features.edges.size()); ++h)
		if (verdicts[whole.panelOf(triangleOf(h))].flat)
			features.edges[h] = SharpFeatures::None;
}

} // namespace

void makeFirstPanels(PlannedSurface& planned, PanelTests& tests, const CutOptions& options,
					 double clusterDeviation) {
	ClusterOptions clusters;
	clusters.greatestDeviation = clusterDeviation;
	const SharpFeatures creases = sharpFeatures(planned.surface, options.creaseAngle);
	divideWhatIsNotFlat(planned, tests, [&](const std::vector<int>& triangles) {
		return regionsBetween(creases, planned.surface, triangles);
	});
	divideWhatIsNotFlat(planned, tests, [&](const std::vector<int>& triangles) {
		return normalClusters(planned.surface, triangles, clusters);
	});
	tidyClusters(planned, creases, options);
	divideUntilFlat(planned, tests, options);
}

std::optional<SharpFeatures> makeStillPanels(PlannedSurface& planned, PanelTests& tests,
											 const CutOptions& options, double still) {
	SharpFeatures features = everySharpEdge(planned.surface, options.creaseAngle);
	divideBetween(features, planned, options);
	if (planned.surface.panelCount() > mostPieces || !isDevelopable(planned.surface))
		return {};
	keepPanelsWhole(planned.surface, tests, features);
	divideBetween(features, planned, options);
	tests.scaleLimits(still);
	divideUntilFlat(planned, tests, options);
	return features;
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
