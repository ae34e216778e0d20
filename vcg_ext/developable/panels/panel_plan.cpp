// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.cpp: the stages of the work.
#include "panel_plan.h"

#include "cut_report.h"
#include "normal_clusters.h"
#include "panel_joining.h"
#include "sewn_panels.h"
#include "slit_labels.h"
#include "smooth_seams.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace developable::detail {

namespace {

constexpr double defaultDisplacement = 0.02; ///< of the diagonal of a part
constexpr double spreads[] = {1.5, 0.7};     ///< of seams that are drawn, the same
constexpr double smoothing = 1.5;            ///< how far labels spread, in mean edge lengths

int countPanels(const CutSurface& surface) {
	int count = 0;
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		count += !surface.trianglesOf(panel).empty();
	return count;
}

/// How bad it is that a panel is not developable, in any unit; 0 when it is.
double excess(const CutPanel& panel) {
	if (panel.triangles == 0 || panel.developable)
		return 0;
	constexpr double least = 1e-300; // what overlaps may not move at all
	return std::max(least, panel.maxDisplacement * (1 + panel.curvatureAfter));
}

/// The panel that holds least, of those that do not; -1: all hold.
int worstOf(const SewnPanels& sewn) {
	const auto worst =
		std::max_element(sewn.panels.begin(), sewn.panels.end(),
						 [](const CutPanel& a, const CutPanel& b) { return excess(a) < excess(b); });
	return excess(*worst) > 0 ? static_cast<int>(worst - sewn.panels.begin()) : -1;
}

} // namespace

PanelPlan::PanelPlan(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
					 const Progress& progress)
	: options_(options),
	  given_(separatePatches(mesh, patches)), planned_{given_.mesh, given_.origins,
													   CutSurface(assemblePatches(given_.mesh, {}))} {
	tests_ = std::make_unique<PanelTests>(maxDisplacements(), options_.material, progress);
}

/// Per patch, length.
std::vector<double> PanelPlan::maxDisplacements() const {
	const PatchAssembly& assembly = planned_.surface.assembly();
	if (options_.maxDisplacement >= 0)
		return std::vector<double>(assembly.patchCount(), options_.maxDisplacement);
	DisjointSets parts(assembly.placeCount() + assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		parts.unite(assembly.placeOfCopy[copy], assembly.placeCount() + assembly.patchOfCopy[copy]);
	std::vector<Eigen::AlignedBox3d> boxes(assembly.placeCount() + assembly.patchCount());
	for (int place = 0; place < assembly.placeCount(); ++place)
		boxes[parts.find(place)].extend(assembly.originalPositions.col(place));
	std::vector<double> result;
	result.reserve(assembly.patchCount());
	for (int patch = 0; patch < assembly.patchCount(); ++patch)
		result.push_back(defaultDisplacement *
						 boxes[parts.find(assembly.placeCount() + patch)].diagonal().norm());
	return result;
}

void PanelPlan::makeClusters() {
	const int patches = planned_.surface.assembly().patchCount();
	std::vector<PanelTrial> trials;
	trials.reserve(patches);
	for (int patch = 0; patch < patches; ++patch)
		trials.push_back({planned_.surface.meshOf(planned_.surface.trianglesOf(patch)), patch});
	const std::vector<PanelVerdict> verdicts = tests_->test(trials);
	for (int patch = 0; patch < patches; ++patch) {
		if (!verdicts[patch].flat)
			planned_.surface.divide(
				patch, normalClusters(planned_.surface, planned_.surface.trianglesOf(patch), {}));
	}
	tidyClusters();
	divideUntilFlat();
}

/// Labels spread a little, which takes away the teeth of their edges.
void PanelPlan::tidyClusters() {
	const Memberships spread =
		memberships(planned_.surface, planned_.surface.panels(), planned_.surface.panelCount(), smoothing,
					options_.creaseAngle, keptTriangles());
	planned_.surface.relabel(planned_.surface.withoutFragments(withSelectedWhole(mostMembership(spread))));
}

std::vector<char> PanelPlan::keptTriangles() const {
	return options_.keepSelected ? planned_.mesh.triangleSelected : std::vector<char>();
}

/// Each connected part of what is selected has one label, that of most of its area, if it is to stay whole.
/// \param labels  per triangle
std::vector<int> PanelPlan::withSelectedWhole(std::vector<int> labels) const {
	if (!options_.keepSelected)
		return labels;
	const int count = planned_.surface.assembly().triangleCount();
	DisjointSets connected(count);
	for (int h = 0; h < 3 * count; ++h) {
		const int other = planned_.surface.assembly().across(h);
		if (other >= 0 && planned_.mesh.triangleSelected[triangleOf(h)] &&
			planned_.mesh.triangleSelected[triangleOf(other)])
			connected.unite(triangleOf(h), triangleOf(other));
	}
	std::map<int, std::map<int, double>> areas; // by part and label
	for (int t = 0; t < count; ++t)
		if (planned_.mesh.triangleSelected[t])
			areas[connected.find(t)][labels[t]] += planned_.surface.areas()[t];
	for (int t = 0; t < count; ++t)
		if (planned_.mesh.triangleSelected[t]) {
			const auto& ofPart = areas[connected.find(t)];
			labels[t] = std::max_element(ofPart.begin(), ofPart.end(), [](const auto& a, const auto& b) {
							return a.second < b.second;
						})->first;
		}
	return labels;
}

/// In two, if that is possible. \return whether it was
bool PanelPlan::divideInTwo(int panel) {
	ClusterOptions options;
	options.greatestDeviation = std::numeric_limits<double>::infinity();
	options.leastClusters = 2;
	const std::vector<int> triangles = planned_.surface.trianglesOf(panel);
	const std::vector<int> halves = normalClusters(planned_.surface, triangles, options);
	std::vector<int> labels(planned_.surface.assembly().triangleCount(), -1);
	for (std::size_t i = 0; i < triangles.size(); ++i)
		labels[triangles[i]] = halves[i];
	labels = withSelectedWhole(std::move(labels));
	std::vector<int> ofPanel;
	ofPanel.reserve(triangles.size());
	for (const int t : triangles)
		ofPanel.push_back(labels[t]);
	if (std::equal(ofPanel.begin() + 1, ofPanel.end(), ofPanel.begin()))
		return false;
	planned_.surface.divide(panel, ofPanel);
	return true;
}

void PanelPlan::divideUntilFlat() {
	std::vector<char> known;
	while (!tests_->stopped()) {
		std::vector<PanelTrial> trials;
		std::vector<int> panels;
		known.resize(planned_.surface.panelCount(), 0);
		for (int panel = 0; panel < planned_.surface.panelCount(); ++panel) {
			const std::vector<int>& triangles = planned_.surface.trianglesOf(panel);
			if (triangles.size() < 2 || known[panel])
				continue;
			const int patch = planned_.surface.assembly().patchOfTriangle[triangles.front()];
			trials.push_back({planned_.surface.meshOf(triangles), patch});
			panels.push_back(panel);
		}
		if (panels.empty() ||
			!tests_->mayGoOn(0.05, "testing " + std::to_string(countPanels(planned_.surface)) + " clusters"))
			return;
		const std::vector<PanelVerdict> verdicts = tests_->test(trials);
		for (std::size_t i = 0; i < panels.size() && !tests_->stopped(); ++i) {
			known[panels[i]] = 1;
			if (!verdicts[i].flat)
				known[panels[i]] = !divideInTwo(panels[i]);
		}
	}
}

SewnPanels PanelPlan::sewTogether(bool brief) {
	return developSewnPanels(meshAsCut(planned_, given_.vertexTaken), planned_.surface, maxDisplacements(),
							 options_.material, brief, progressOfRest());
}

/// Sewn together, panels pull at each other.
SewnExcess PanelPlan::sewnExcess() {
	return [this] {
		double sum = 0;
		for (const CutPanel& panel : sewTogether(true).panels)
			sum += excess(panel);
		return sum;
	};
}

/// Divides what does not hold together, in two each time.
SewnPanels PanelPlan::divideUntilAllHold() {
	constexpr int rounds = 40;
	SewnPanels sewn = sewTogether(false);
	for (int round = 0; round < rounds && !tests_->stopped(); ++round) {
		const int worst = worstOf(sewn);
		if (worst < 0 || planned_.surface.trianglesOf(worst).size() < 2 || !divideInTwo(worst))
			break;
		sewn = sewTogether(false);
	}
	return sewn;
}

Progress PanelPlan::progressOfRest() {
	return [this](double, const std::string&) { return tests_->mayGoOn(0.7, "sewing the panels together"); };
}

/// Seams between the same two panels, or the slit of one, need clusters as labels: these say which chains of
/// the new seams go.
void PanelPlan::drawSmoothSeams(double edges) {
	SlitLabels before(planned_.surface, clusters_);
	const Memberships spread = memberships(planned_.surface, before.labels(), before.count(), edges,
										   options_.creaseAngle, keptTriangles());
	if (!options_.splitTriangles) {
		CutSurface drawn = planned_.surface;
		const std::vector<int> labels = drawn.withoutFragments(withSelectedWhole(mostMembership(spread)));
		drawn.relabel(labels);
		before.openWithin(drawn, labels);
		planned_.surface = std::move(drawn);
		return;
	}
	SplitMesh split = splitAlongSeams(planned_.mesh, planned_.surface, spread);
	for (VertexOrigin& origin : split.origins)
		origin = {planned_.origins[origin.first].first, planned_.origins[origin.second].first, origin.share};
	for (int& face : split.mesh.face)
		face = planned_.mesh.face[face];
	CutSurface drawn(assemblePatches(split.mesh, {}));
	const std::vector<int> labels = drawn.withoutFragments(split.labels);
	drawn.relabel(labels);
	before.openWithin(drawn, labels);
	planned_ = {std::move(split.mesh), std::move(split.origins), std::move(drawn)};
}

/// Panels that hold by themselves may not when they are sewn together with smooth seams: then the last join
/// of the worst is taken back, and its halves may go to others.
void PanelPlan::joinUntilAllHold() {
	constexpr int rounds = 12;
	for (int round = 1; !tests_->stopped(); ++round) {
		joinPanels(planned_.surface, *tests_, history_);
		if (tests_->stopped() || seamChains(planned_.surface).empty())
			return;
		const PlannedSurface joined = planned_;
		const SewnPanels sewn = smoothSeams();
		const int worst = worstOf(sewn);
		if (worst < 0 || round == rounds || tests_->stopped())
			return;
		PlannedSurface divided = joined;
		if (!history_.takeBack(divided.surface, panelBefore(joined, worst)))
			return;
		planned_ = std::move(divided);
	}
}

/// The panel of a surface that was there before faces were split which has most of a panel that is there now.
int PanelPlan::panelBefore(const PlannedSurface& before, int panel) const {
	std::map<int, int> triangleOfFace;
	for (int t = 0; t < before.mesh.triangleCount(); ++t)
		triangleOfFace[before.mesh.face[t]] = t;
	std::map<int, double> areas;
	for (const int t : planned_.surface.trianglesOf(panel))
		areas[before.surface.panelOf(triangleOfFace.at(planned_.mesh.face[t]))] +=
			planned_.surface.areas()[t];
	return std::max_element(areas.begin(), areas.end(),
							[](const auto& a, const auto& b) { return a.second < b.second; })
		->first;
}

/// Smooth seams move a little. Where that spoils what would hold they move less.
SewnPanels PanelPlan::smoothSeams() {
	const PlannedSurface before = planned_;
	SewnPanels sewn;
	for (const double spread : spreads) {
		planned_ = before;
		drawSmoothSeams(spread);
		sewn = sewTogether(true);
		const bool sameCount = countPanels(planned_.surface) <= countPanels(before.surface);
		if (tests_->stopped() || (sameCount && worstOf(sewn) < 0))
			break;
	}
	return sewn;
}

CutResult PanelPlan::run() {
	makeClusters();
	clusters_ = planned_.surface.panels();
	joinUntilAllHold();
	if (!tests_->stopped() && options_.darts && options_.splitTriangles)
		joinWithDarts(planned_.surface, *tests_, sewnExcess());
	SewnPanels sewn = divideUntilAllHold();
	if (options_.maxPanels > 0 && countPanels(planned_.surface) > options_.maxPanels) {
		joinToSoFew();
		sewn = sewTogether(false);
	}
	CutResult result;
	if (tests_->stopped()) {
		result.report.status = Status::Stopped;
		return result;
	}
	result.report = reportOf(planned_.surface, sewn, given_.seamLength, options_);
	result.mesh = cutMesh(planned_, given_.vertexTaken);
	return result;
}

/// At the price of larger displacements.
void PanelPlan::joinToSoFew() {
	constexpr int doublings = 4;
	for (int i = 0; i < doublings && !tests_->stopped() && countPanels(planned_.surface) > options_.maxPanels;
		 ++i) {
		tests_->relax(2);
		history_.tryAllAgain();
		joinPanels(planned_.surface, *tests_, history_);
		if (options_.darts && options_.splitTriangles)
			joinWithDarts(planned_.surface, *tests_, sewnExcess());
	}
}

} // namespace developable::detail
