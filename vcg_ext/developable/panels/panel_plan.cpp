// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.cpp: the stages of the work.
#include "panel_plan.h"

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

/// Of the sides of different patches that have both ends in common, length.
/// \param vertices  3 x triangles of the assembly, in the mesh that was given
double lengthOfSharedSides(const PatchAssembly& assembly, const Eigen::Matrix3Xi& vertices) {
	std::map<std::pair<int, int>, int> sides;
	double length = 0;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const auto ends = std::minmax(vertices.data()[h], vertices.data()[nextCorner(h)]);
		if (assembly.across(h) < 0 && ++sides[ends] == 2)
			length += (assembly.originalPositions.col(assembly.placeAt(h)) -
					   assembly.originalPositions.col(assembly.placeAt(nextCorner(h))))
						  .norm();
	}
	return length;
}

} // namespace

PanelPlan::PanelPlan(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
					 const Progress& progress)
	: options_(options) {
	separatePatches(mesh, patches);
	surface_ = std::make_unique<CutSurface>(assemblePatches(mesh_, {}));
	tests_ = std::make_unique<PanelTests>(maxDisplacements(), options_.material, progress);
}

void PanelPlan::separatePatches(const TriangleMesh& mesh, const PatchOptions& patches) {
	const PatchAssembly given = assemblePatches(mesh, patches);
	std::vector<int> triangleOfFace(mesh.face.empty() ? 0 : mesh.face.back() + 1, -1);
	for (int t = 0; t < mesh.triangleCount(); ++t)
		triangleOfFace[mesh.face[t]] = t;
	mesh_.positions.resize(3, given.copyCount());
	mesh_.triangles = given.triangleCopies;
	mesh_.vertexSelected.assign(given.copyCount(), 0);
	mesh_.leastHeightRatio = mesh.leastHeightRatio;
	mesh_.lengthExponent = mesh.lengthExponent;
	mesh_.face = given.faceOfTriangle;
	origins_.resize(given.copyCount());
	std::vector<char> worked(mesh.triangleCount(), 0);
	Eigen::Matrix3Xi vertices(3, given.triangleCount());
	for (int corner = 0; corner < 3 * given.triangleCount(); ++corner) {
		const int copy = given.copyAt(corner), t = triangleOfFace[given.faceOfTriangle[triangleOf(corner)]];
		const int vertex = mesh.triangles(cornerInTriangle(corner), t);
		worked[t] = 1;
		vertices.data()[corner] = vertex;
		origins_[copy] = {vertex, vertex, 0};
		mesh_.positions.col(copy) = given.originalPositions.col(given.placeOfCopy[copy]);
		if (cornerInTriangle(corner) == 0)
			mesh_.triangleSelected.push_back(mesh.triangleSelected[t]);
	}
	givenSeamLength_ = lengthOfSharedSides(given, vertices);
	vertexTaken_.assign(mesh.vertexCount(), 0);
	for (int t = 0; t < mesh.triangleCount(); ++t)
		for (int corner = 0; corner < 3 && !worked[t]; ++corner)
			vertexTaken_[mesh.triangles(corner, t)] = 1;
}

/// Per patch, length.
std::vector<double> PanelPlan::maxDisplacements() const {
	const PatchAssembly& assembly = surface_->assembly();
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
	const int patches = surface_->assembly().patchCount();
	std::vector<PanelTrial> trials;
	trials.reserve(patches);
	for (int patch = 0; patch < patches; ++patch)
		trials.push_back({surface_->meshOf(surface_->trianglesOf(patch)), patch});
	const std::vector<PanelVerdict> verdicts = tests_->test(trials);
	for (int patch = 0; patch < patches; ++patch) {
		if (!verdicts[patch].flat)
			surface_->divide(patch, normalClusters(*surface_, surface_->trianglesOf(patch), {}));
	}
	tidyClusters();
	divideUntilFlat();
}

/// Labels spread a little, which takes away the teeth of their edges.
void PanelPlan::tidyClusters() {
	const Memberships spread = memberships(*surface_, surface_->panels(), surface_->panelCount(), smoothing,
										   options_.creaseAngle, keptTriangles());
	surface_->relabel(surface_->withoutFragments(withSelectedWhole(mostMembership(spread))));
}

std::vector<char> PanelPlan::keptTriangles() const {
	return options_.keepSelected ? mesh_.triangleSelected : std::vector<char>();
}

/// Each connected part of what is selected has one label, that of most of its area, if it is to stay whole.
/// \param labels  per triangle
std::vector<int> PanelPlan::withSelectedWhole(std::vector<int> labels) const {
	if (!options_.keepSelected)
		return labels;
	const int count = surface_->assembly().triangleCount();
	DisjointSets connected(count);
	for (int h = 0; h < 3 * count; ++h) {
		const int other = surface_->assembly().across(h);
		if (other >= 0 && mesh_.triangleSelected[triangleOf(h)] && mesh_.triangleSelected[triangleOf(other)])
			connected.unite(triangleOf(h), triangleOf(other));
	}
	std::map<int, std::map<int, double>> areas; // by part and label
	for (int t = 0; t < count; ++t)
		if (mesh_.triangleSelected[t])
			areas[connected.find(t)][labels[t]] += surface_->areas()[t];
	for (int t = 0; t < count; ++t)
		if (mesh_.triangleSelected[t]) {
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
	const std::vector<int> triangles = surface_->trianglesOf(panel);
	const std::vector<int> halves = normalClusters(*surface_, triangles, options);
	std::vector<int> labels(surface_->assembly().triangleCount(), -1);
	for (std::size_t i = 0; i < triangles.size(); ++i)
		labels[triangles[i]] = halves[i];
	labels = withSelectedWhole(std::move(labels));
	std::vector<int> ofPanel;
	ofPanel.reserve(triangles.size());
	for (const int t : triangles)
		ofPanel.push_back(labels[t]);
	if (std::equal(ofPanel.begin() + 1, ofPanel.end(), ofPanel.begin()))
		return false;
	surface_->divide(panel, ofPanel);
	return true;
}

void PanelPlan::divideUntilFlat() {
	std::vector<char> known;
	while (!tests_->stopped()) {
		std::vector<PanelTrial> trials;
		std::vector<int> panels;
		known.resize(surface_->panelCount(), 0);
		for (int panel = 0; panel < surface_->panelCount(); ++panel) {
			const std::vector<int>& triangles = surface_->trianglesOf(panel);
			if (triangles.size() < 2 || known[panel])
				continue;
			const int patch = surface_->assembly().patchOfTriangle[triangles.front()];
			trials.push_back({surface_->meshOf(triangles), patch});
			panels.push_back(panel);
		}
		if (panels.empty() ||
			!tests_->mayGoOn(0.05, "testing " + std::to_string(countPanels(*surface_)) + " clusters"))
			return;
		const std::vector<PanelVerdict> verdicts = tests_->test(trials);
		for (std::size_t i = 0; i < panels.size() && !tests_->stopped(); ++i) {
			known[panels[i]] = 1;
			if (!verdicts[i].flat)
				known[panels[i]] = !divideInTwo(panels[i]);
		}
	}
}

SewnPanels PanelPlan::sewTogether(double share, bool brief) {
	std::vector<double> limits = maxDisplacements();
	for (double& limit : limits)
		limit *= share;
	return developSewnPanels(asCut(), *surface_, limits, options_.material, brief, progressOfRest());
}

/// Sewn together, panels pull at each other.
SewnExcess PanelPlan::excessBeyond(double share) {
	return [this, share] {
		double sum = 0;
		for (const CutPanel& panel : sewTogether(share, true).panels)
			sum += excess(panel);
		return sum;
	};
}

/// Divides what does not hold together, in two each time.
SewnPanels PanelPlan::divideUntilAllHold() {
	constexpr int rounds = 40;
	SewnPanels sewn = sewTogether(1, false);
	for (int round = 0; round < rounds && !tests_->stopped(); ++round) {
		int worst = 0;
		for (int panel = 0; panel < surface_->panelCount(); ++panel)
			if (excess(sewn.panels[panel]) > excess(sewn.panels[worst]))
				worst = panel;
		if (excess(sewn.panels[worst]) == 0 || surface_->trianglesOf(worst).size() < 2 || !divideInTwo(worst))
			break;
		sewn = sewTogether(1, false);
	}
	return sewn;
}

Progress PanelPlan::progressOfRest() {
	return [this](double, const std::string&) { return tests_->mayGoOn(0.7, "sewing the panels together"); };
}

/// Seams between the same two panels, or the slit of one, need clusters as labels: these say which chains of
/// the new seams go.
void PanelPlan::drawSmoothSeams(double edges) {
	SlitLabels before(*surface_, clusters_);
	const Memberships spread =
		memberships(*surface_, before.labels(), before.count(), edges, options_.creaseAngle, keptTriangles());
	if (!options_.splitTriangles) {
		CutSurface drawn = *surface_;
		const std::vector<int> labels = drawn.withoutFragments(withSelectedWhole(mostMembership(spread)));
		drawn.relabel(labels);
		before.openWithin(drawn, labels);
		*surface_ = std::move(drawn);
		return;
	}
	SplitMesh split = splitAlongSeams(mesh_, *surface_, spread);
	for (VertexOrigin& origin : split.origins)
		origin = {origins_[origin.first].first, origins_[origin.second].first, origin.share};
	for (int& face : split.mesh.face)
		face = mesh_.face[face];
	mesh_ = std::move(split.mesh);
	origins_ = std::move(split.origins);
	auto drawn = std::make_unique<CutSurface>(assemblePatches(mesh_, {}));
	const std::vector<int> labels = drawn->withoutFragments(split.labels);
	drawn->relabel(labels);
	before.openWithin(*drawn, labels);
	surface_ = std::move(drawn);
}

/// Panels that hold by themselves may not when they are sewn together with smooth seams: then the last join
/// of the worst is taken back, and its halves may go to others.
void PanelPlan::joinUntilAllHold() {
	constexpr int rounds = 12;
	for (int round = 1; !tests_->stopped(); ++round) {
		joinPanels(*surface_, *tests_, history_);
		if (tests_->stopped() || seamChains(*surface_).empty())
			return;
		const CutSurface joined = *surface_;
		const TriangleMesh meshBefore = mesh_;
		const std::vector<VertexOrigin> originsBefore = origins_;
		const SewnPanels sewn = smoothSeams();
		const int worst = worstOf(sewn);
		if (worst < 0 || round == rounds || tests_->stopped())
			return;
		const int panel = panelBefore(joined, meshBefore, worst);
		CutSurface divided = joined;
		if (!history_.takeBack(divided, panel))
			return;
		*surface_ = std::move(divided);
		mesh_ = meshBefore;
		origins_ = originsBefore;
	}
}

/// The panel of a surface that was there before faces were split which has most of a panel that is there now.
int PanelPlan::panelBefore(const CutSurface& before, const TriangleMesh& meshBefore, int panel) const {
	std::map<int, int> triangleOfFace;
	for (int t = 0; t < meshBefore.triangleCount(); ++t)
		triangleOfFace[meshBefore.face[t]] = t;
	std::map<int, double> areas;
	for (const int t : surface_->trianglesOf(panel))
		areas[before.panelOf(triangleOfFace.at(mesh_.face[t]))] += surface_->areas()[t];
	return std::max_element(areas.begin(), areas.end(),
							[](const auto& a, const auto& b) { return a.second < b.second; })
		->first;
}

/// Smooth seams move a little. Where that spoils what would hold they move less.
SewnPanels PanelPlan::smoothSeams() {
	const CutSurface before = *surface_;
	const TriangleMesh meshBefore = mesh_;
	const std::vector<VertexOrigin> originsBefore = origins_;
	SewnPanels sewn;
	for (const double spread : spreads) {
		*surface_ = before;
		mesh_ = meshBefore;
		origins_ = originsBefore;
		drawSmoothSeams(spread);
		sewn = sewTogether(1, true);
		const bool sameCount = countPanels(*surface_) <= countPanels(before);
		if (tests_->stopped() || (sameCount && worstOf(sewn) < 0))
			break;
	}
	return sewn;
}

CutResult PanelPlan::run() {
	makeClusters();
	clusters_ = surface_->panels();
	joinUntilAllHold();
	if (!tests_->stopped() && options_.darts && options_.splitTriangles)
		joinWithDarts(*surface_, *tests_, excessBeyond(1));
	SewnPanels sewn = divideUntilAllHold();
	if (options_.maxPanels > 0 && countPanels(*surface_) > options_.maxPanels) {
		joinToSoFew();
		sewn = sewTogether(1, false);
	}
	CutResult result;
	result.report = reportOf(sewn);
	if (!tests_->stopped())
		result.mesh = cutMesh();
	return result;
}

/// At the price of larger displacements.
void PanelPlan::joinToSoFew() {
	constexpr int doublings = 4;
	for (int i = 0; i < doublings && !tests_->stopped() && countPanels(*surface_) > options_.maxPanels; ++i) {
		tests_->relax(2);
		history_.tryAllAgain();
		joinPanels(*surface_, *tests_, history_);
		if (options_.darts && options_.splitTriangles)
			joinWithDarts(*surface_, *tests_, excessBeyond(1));
	}
}

CutReport PanelPlan::reportOf(const SewnPanels& sewn) const {
	CutReport report;
	if (tests_->stopped()) {
		report.status = Status::Stopped;
		return report;
	}
	report.meanDisplacement = sewn.meanDisplacement;
	report.maxDisplacement = sewn.maxDisplacement;
	report.smallestPanelArea = std::numeric_limits<double>::infinity();
	std::vector<char> seen(surface_->panelCount(), 0);
	for (int t = 0; t < surface_->assembly().triangleCount(); ++t) { // panels are numbered as in the cut mesh
		const int panel = surface_->panelOf(t);
		if (seen[panel])
			continue;
		seen[panel] = 1;
		report.panels.push_back(sewn.panels[panel]);
		report.smallestPanelArea = std::min(report.smallestPanelArea, sewn.panels[panel].area);
	}
	report.seamLength = givenSeamLength_;
	for (const SeamChain& chain : seamChains(*surface_)) {
		report.seamLength += chain.length;
		report.darts += chain.isDart();
	}
	const auto bad = std::count_if(report.panels.begin(), report.panels.end(),
								   [](const CutPanel& panel) { return !panel.developable; });
	const bool soFew = options_.maxPanels > 0 && int(report.panels.size()) >= options_.maxPanels;
	const bool uncut = seamChains(*surface_).empty();
	const bool tooMany = !uncut && soFew && int(report.panels.size()) > options_.maxPanels;
	report.status = bad > 0                          ? (soFew ? Status::LimitReached : Status::NeedsCut)
					: tooMany                        ? Status::LimitReached
					: uncut && givenSeamLength_ == 0 ? Status::NothingToDo
													 : Status::Converged;
	if (tooMany)
		report.notes.push_back("No way was found to make do with " +
							   counted(std::size_t(options_.maxPanels), "panel", "panels") +
							   ": there are as few as could be joined.");
	if (bad > 0) {
		report.notes.push_back(
			counted(std::size_t(bad), "panel", "panels") + " of " + std::to_string(report.panels.size()) +
			" can't be made developable within the largest displacement: allow a larger one" +
			(soFew                   ? ", or more panels."
			 : options_.keepSelected ? ", or select less to keep whole."
									 : "."));
	}
	return report;
}

/// The triangles in the order that they have once the mesh is cut; `face` is their number on the surface.
TriangleMesh PanelPlan::asCut() const {
	const CutMesh cut = cutMesh();
	const std::vector<int> after = cut.facesAfter(1 + *std::max_element(cut.face.begin(), cut.face.end()));
	TriangleMesh mesh;
	mesh.face.resize(after.size());
	std::iota(mesh.face.begin(), mesh.face.end(), 0);
	std::sort(mesh.face.begin(), mesh.face.end(), [&](int a, int b) { return after[a] < after[b]; });
	mesh.triangles = cut.triangles(Eigen::all, mesh.face);
	mesh.positions = Positions::Zero(3, cut.verticesBefore + int(cut.added.size()));
	for (int corner = 0; corner < int(cut.triangles.size()); ++corner)
		mesh.positions.col(cut.triangles.data()[corner]) =
			surface_->positions().col(surface_->assembly().placeAt(corner));
	mesh.vertexSelected.assign(mesh.vertexCount(), 0);
	mesh.triangleSelected.assign(mesh.triangleCount(), 0);
	mesh.leastHeightRatio = mesh_.leastHeightRatio;
	mesh.lengthExponent = mesh_.lengthExponent;
	return mesh;
}

CutMesh PanelPlan::cutMesh() const {
	CutMesh cut;
	cut.verticesBefore = static_cast<int>(vertexTaken_.size());
	std::vector<int> all(surface_->assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	const TriangleMesh separate = surface_->meshOf(all);
	std::vector<char> taken = vertexTaken_;
	std::vector<int> numberOf(separate.vertexCount(), -1);
	cut.triangles.resize(3, all.size());
	for (int corner = 0; corner < 3 * separate.triangleCount(); ++corner) {
		int& number = numberOf[vertexAt(separate, corner)];
		if (number < 0) {
			const VertexOrigin origin = origins_[vertexAt(mesh_, corner)];
			if (origin.first == origin.second && !taken[origin.first]) {
				number = origin.first;
				taken[number] = 1;
			} else {
				number = cut.verticesBefore + static_cast<int>(cut.added.size());
				cut.added.push_back(origin);
			}
		}
		cut.triangles.data()[corner] = number;
	}
	std::vector<int> dense(surface_->panelCount(), -1);
	int panels = 0;
	for (const int t : all) {
		int& panel = dense[surface_->panelOf(t)];
		if (panel < 0)
			panel = panels++;
		cut.panel.push_back(panel);
		cut.face.push_back(mesh_.face[t]);
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			cut.seam.push_back(surface_->isCut(h));
	}
	return cut;
}

} // namespace developable::detail
