// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.cpp: the stages of the work.
#include "panel_plan.h"

#include "cut_report.h"
#include "normal_clusters.h"
#include "overlap_division.h"
#include "panel_dissolving.h"
#include "panel_joining.h"
#include "seam_drawing.h"
#include "selected_whole.h"
#include "sewn_panels.h"
#include "sewn_relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace developable::detail {

namespace {

constexpr double defaultDisplacement = 0.02; ///< of the diagonal of a part
constexpr double smoothing = 1.5;            ///< how far labels spread, in mean edge lengths

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
		trials.push_back(trialOf(planned_.surface, planned_.surface.trianglesOf(patch)));
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
	const int count = planned_.surface.assembly().triangleCount();
	const Spreading spreading{sharpFeatures(planned_.surface, options_.creaseAngle),
							  std::vector<double>(count, smoothing), std::vector<char>(count, 1)};
	const Memberships spread =
		memberships(planned_.surface, planned_.surface.panels(), planned_.surface.panelCount(), spreading,
					keptTriangles(planned_, options_));
	planned_.surface.relabel(
		planned_.surface.withoutFragments(withSelectedWhole(planned_, options_, mostMembership(spread))));
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
	labels = withSelectedWhole(planned_, options_, std::move(labels));
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
			trials.push_back(trialOf(planned_.surface, triangles));
			panels.push_back(panel);
		}
		if (panels.empty() ||
			!tests_->mayGoOn(0.05,
							 "testing " + std::to_string(planned_.surface.usedPanelCount()) + " clusters"))
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
	return [this] { return totalExcess(sewTogether(true)); };
}

/// Where some panels do not hold after that, what did before is the better.
SewnPanels PanelPlan::joinedWithDarts() {
	if (tests_->stopped() || !options_.darts || !options_.splitTriangles)
		return divideUntilAllHold();
	const PlannedSurface before = planned_;
	joinWithDarts(planned_.surface, *tests_, sewnExcess());
	SewnPanels sewn = sewTogether(false);
	if (worstOf(sewn) < 0 || tests_->stopped())
		return sewn;
	planned_ = before;
	return divideUntilAllHold();
}

/// Divides what does not hold together, and where darts do not help, in two each time.
SewnPanels PanelPlan::divideUntilAllHold() {
	constexpr int rounds = 40;
	reliefsLeft_ = mostReliefs;
	SewnPanels sewn = relieved(sewTogether(false));
	for (int round = 0; round < rounds && !tests_->stopped(); ++round) {
		const int worst = worstOf(sewn);
		if (worst < 0 || planned_.surface.trianglesOf(worst).size() < 2 || !divideInTwo(worst))
			break;
		sewn = relieved(sewTogether(false));
	}
	return sewn;
}

Progress PanelPlan::progressOfRest() {
	return [this](double, const std::string&) { return tests_->mayGoOn(0.7, "sewing the panels together"); };
}

/// As few panels as can be, if these hold when they are sewn together, or soon do; else those that were
/// joined greedily, which are more and hold sooner.
void PanelPlan::joinUntilAllHold() {
	constexpr int roundsOfFew = 8, rounds = 12;
	joinPanels(planned_.surface, *tests_, history_);
	const PlannedSurface joined = planned_;
	dissolvePanels(planned_.surface, clusters_, *tests_, history_);
	if (options_.darts && options_.splitTriangles)
		joinWithRelief(planned_.surface, *tests_, history_, dartTips_, keptTriangles(planned_, options_));
	const bool fewer = planned_.surface.usedPanelCount() < joined.surface.usedPanelCount();
	if (sewUntilAllHold(fewer ? roundsOfFew : rounds) || !fewer || tests_->stopped())
		return;
	planned_ = joined;
	dartTips_.clear();
	sewUntilAllHold(rounds);
}

/// Panels that hold by themselves may not when they are sewn together with smooth seams: then the last joins
/// of those that do not are taken back, and halves may go to others. \return whether all hold
bool PanelPlan::sewUntilAllHold(int rounds) {
	constexpr double tighter = 0.95; // with every round: panels with more room hold sooner
	reliefsLeft_ = mostReliefs;
	bool mayJoin = false;
	for (int round = 1; !tests_->stopped(); ++round) {
		tests_->scaleLimits(std::pow(tighter, round - 1));
		if (mayJoin)
			joinPanels(planned_.surface, *tests_, history_);
		if (tests_->stopped() || seamChains(planned_.surface).empty())
			return true;
		const PlannedSurface joined = planned_;
		const std::vector<Eigen::Vector3d> dartTips = dartTips_;
		const SewnPanels sewn = smoothSeams();
		const std::vector<int> failing = worstFirst(sewn);
		if (failing.empty())
			return true;
		PlannedSurface divided = joined;
		mayJoin = sewn.overlaps.size() < failing.size();
		if (round == rounds || tests_->stopped() ||
			!(mayJoin ? takeBackLastJoins(divided.surface, joined, failing)
					  : divideOverlapping(divided.surface, joined, sewn)))
			return false;
		planned_ = std::move(divided);
		dartTips_ = dartTips;
	}
	return false;
}

/// Of all panels that do not hold. \return whether there was any
bool PanelPlan::takeBackLastJoins(CutSurface& surface, const PlannedSurface& joined,
								  const std::vector<int>& failing) {
	std::set<int> panels;
	bool any = false;
	for (const int panel : failing) {
		const int before = panelBefore(joined, panel);
		if (panels.insert(before).second && takeBackLastJoin(surface, before))
			any = true;
	}
	return any;
}

/// Panels that fail only for they overlap themselves when laid flat are divided there.
/// \return whether any could be
bool PanelPlan::divideOverlapping(CutSurface& surface, const PlannedSurface& joined, const SewnPanels& sewn) {
	bool any = false;
	for (const auto& [panel, points] : sewn.overlaps) {
		const int before = panelBefore(joined, panel);
		history_.neverAgain(surface, before);
		any = divideBetween(surface, before, points) || any;
	}
	return any;
}

/// The last that had two halves of a size to be seen. \return whether there was any
bool PanelPlan::takeBackLastJoin(CutSurface& surface, int panel) {
	constexpr double tooSmall = 0.01; // of the patch: the drawing of seams may lose it
	const int patch = surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()];
	const double least = tooSmall * surface.patchArea(patch);
	while (true) {
		const double whole = surface.area(panel);
		const std::vector<int> triangles = surface.trianglesOf(panel);
		if (!history_.takeBack(surface, panel))
			return false;
		for (const int t : triangles)
			if (surface.area(surface.panelOf(t)) > surface.area(panel))
				panel = surface.panelOf(t);
		if (whole - surface.area(panel) >= least)
			return true;
	}
}

/// With darts where that makes all hold.
SewnPanels PanelPlan::relieved(SewnPanels sewn) {
	constexpr std::size_t mostFailing = 3; // else panels are too large, and not just a little
	if (!options_.darts || !options_.splitTriangles || worstFirst(sewn).size() > mostFailing)
		return sewn;
	return SewnRelief(planned_, options_, *tests_, dartTips_, reliefsLeft_,
					  [this] { return sewTogether(true); })
		.relieved(std::move(sewn));
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

/// Smooth seams move a little: first as little as can be, and where that holds as much as holds.
SewnPanels PanelPlan::smoothSeams() {
	const PlannedSurface before = planned_;
	SeamDrawing drawing(before, clusters_, dartTips_, options_);
	planned_ = drawing.drawn();
	SewnPanels sewn = relieved(sewTogether(true));
	const auto holds = [&](const SewnPanels& panels) {
		return planned_.surface.usedPanelCount() <= before.surface.usedPanelCount() && worstOf(panels) < 0;
	};
	constexpr int rounds = 4;
	drawing.smoothen();
	for (int round = 0; round < rounds && !tests_->stopped() && holds(sewn); ++round) {
		const PlannedSurface safe = std::exchange(planned_, drawing.drawn());
		SewnPanels smoother = sewTogether(true);
		if (holds(smoother))
			return smoother;
		const bool mayBeTighter = drawing.tightenAt(worstPoints(smoother));
		planned_ = safe;
		if (!mayBeTighter)
			break;
	}
	return sewn;
}

CutResult PanelPlan::run() {
	makeClusters();
	clusters_ = planned_.surface.panels();
	joinUntilAllHold();
	SewnPanels sewn = joinedWithDarts();
	if (options_.maxPanels > 0 && planned_.surface.usedPanelCount() > options_.maxPanels) {
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
	for (int i = 0;
		 i < doublings && !tests_->stopped() && planned_.surface.usedPanelCount() > options_.maxPanels; ++i) {
		tests_->scaleLimits(std::pow(2, i + 1));
		history_.tryAllAgain();
		joinPanels(planned_.surface, *tests_, history_);
		if (options_.darts && options_.splitTriangles)
			joinWithDarts(planned_.surface, *tests_, sewnExcess());
	}
}

} // namespace developable::detail
