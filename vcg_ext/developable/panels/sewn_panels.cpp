// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_panels.cpp: one run of the method that Global Developability will use, read panel by panel.
#include "sewn_panels.h"

#include "border_parts.h"
#include "sewn_failures.h"

#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/newton/constrained_newton.h"

#include <algorithm>
#include <optional>

namespace developable::detail {

namespace {

/// Of more places a coarse level has so many, or seams would be all that is left of its panels.
constexpr int manyPlaces = 6000, placesOfMany = 2500;
/// Of how far a panel may move: shorter stretches of its border that lie upon it are left to the whole run.
constexpr double littleOverlap = 3;
/// Of how far panels may move: from so far away a brief run looks for closer shapes.
constexpr double nearlyWithin = 1.3;

/// A panel without a border can't be made developable. \return whether there is any
bool markClosed(const PatchAssembly& assembly, const CutSurface& surface, SewnPanels& result) {
	bool any = false;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		CutPanel& panel = result.panels[surface.panelOf(assembly.faceOfTriangle[t])];
		++panel.triangles;
		panel.developable = !assembly.patches[assembly.patchOfTriangle[t]].closed();
		if (panel.developable)
			continue;
		any = true;
		panel.reason = Reason::NeedsCut;
		panel.maxDisplacement = boxDiagonal(surface.positions());
		panel.curvatureAfter = 4 * pi; // of a closed surface it is never less
	}
	return any;
}

/// The panel of each patch of the assembly.
std::vector<int> panelsOfPatches(const PatchAssembly& assembly, const CutSurface& surface) {
	std::vector<int> panels(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		panels[assembly.patchOfTriangle[t]] = surface.panelOf(assembly.faceOfTriangle[t]);
	return panels;
}

/// Of each panel its limit, of those per patch of the surface.
std::vector<double> limitsOfPanels(const CutSurface& surface, const std::vector<double>& maxDisplacement) {
	std::vector<double> limits(surface.panelCount(), 0);
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (!surface.trianglesOf(panel).empty())
			limits[panel] =
				maxDisplacement[surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()]];
	return limits;
}

/// Moves and curvature of every panel.
/// \param limits  per panel: what is moved farther is what is worst
void measurePanels(const PatchAssembly& assembly, const Positions& positions, const CutSurface& surface,
				   const std::vector<int>& panelOfPatch, const std::vector<double>& limits,
				   SewnPanels& result) {
	const Eigen::VectorXd before = angleDefects(assembly, assembly.originalPositions);
	const Eigen::VectorXd after = angleDefects(assembly, positions);
	const Eigen::VectorXd moves = displacementMap(assembly.originalPositions, positions);
	result.meanDisplacement = moves.mean();
	result.maxDisplacement = moves.maxCoeff();
	std::vector<int> copies(surface.panelCount(), 0);
	std::vector<double> worst(surface.panelCount(), -1);
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int panel = panelOfPatch[assembly.patchOfCopy[copy]], place = assembly.placeOfCopy[copy];
		CutPanel& report = result.panels[panel];
		report.curvatureBefore += std::abs(before[copy]);
		report.curvatureAfter += std::abs(after[copy]);
		report.maxAngleDefect = std::max(report.maxAngleDefect, std::abs(after[copy]));
		report.meanDisplacement += moves[place];
		report.maxDisplacement = std::max(report.maxDisplacement, moves[place]);
		++copies[panel];
		const double far = moves[place] > limits[panel] ? 1e3 * moves[place] / result.maxDisplacement : 0;
		if (std::abs(after[copy]) + far > worst[panel]) {
			worst[panel] = std::abs(after[copy]) + far;
			report.worstPoint = assembly.originalPositions.col(place);
		}
	}
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (copies[panel] > 0) {
			result.panels[panel].triangles = static_cast<int>(surface.trianglesOf(panel).size());
			result.panels[panel].area = surface.area(panel);
			result.panels[panel].meanDisplacement /= copies[panel];
		}
}

/// Half edges of the assembly as ones of the surface.
std::vector<int> onSurface(const PatchAssembly& assembly, const std::vector<int>& halfEdges) {
	std::vector<int> result;
	result.reserve(halfEdges.size());
	for (const int h : halfEdges)
		result.push_back(3 * assembly.faceOfTriangle[triangleOf(h)] + cornerInTriangle(h));
	return result;
}

Positions cornersOf(const PatchAssembly& assembly, const Positions& positions, const CutSurface& surface) {
	Positions corners(3, 3 * surface.assembly().triangleCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		corners.middleCols<3>(3 * assembly.faceOfTriangle[t]) =
			positions(Eigen::all, assembly.trianglePlaces.col(t));
	return corners;
}

/// Panels that overlap themselves when laid flat, or need a cut for it, are none, however developable.
/// \param little  per panel, length: shorter stretches upon the panel itself are no matter; empty: all are
void refuseOverlaps(const PatchAssembly& assembly, const Positions& positions, const CutSurface& surface,
					const std::vector<int>& panelOfPatch, const std::vector<double>& little,
					SewnPanels& result) {
	constexpr double farthest = 0.2; // share of a border: what goes farther is no matter of a dart or a notch
	const FlatPatterns patterns = flattenPatches(assembly, positions);
	const auto pointAt = [&](int h) { // inside the triangle: beside a slit, not on it
		return barycentre(assembly.originalPositions, assembly.trianglePlaces.col(triangleOf(h)));
	};
	result.corners = cornersOf(assembly, positions, surface);
	for (std::size_t patch = 0; patch < patterns.pieces.size(); ++patch) {
		const FlatPiece& piece = patterns.pieces[patch];
		if (!piece.overlapping && piece.cuts == 0)
			continue;
		if (piece.cuts == 0 && !little.empty() &&
			coveredStretch(patterns, piece) <= little[panelOfPatch[patch]])
			continue;
		CutPanel& panel = result.panels[panelOfPatch[patch]];
		panel.developable = false;
		panel.reason = Reason::NeedsCut;
		if (piece.crossings.empty())
			continue;
		const std::vector<BorderPart> notches = notchesOf(patterns, piece);
		const std::vector<int>& largest = largestNotch(notches).halfEdges;
		const bool ofTwoBorders = largest.empty();
		panel.worstPoint = pointAt(ofTwoBorders ? piece.crossings.front()[0] : largest.front());
		result.overlaps[panelOfPatch[patch]] = {
			panel.worstPoint, pointAt(ofTwoBorders ? piece.crossings.front()[1] : largest.back())};
		if (largestNotch(notches).share > farthest)
			continue;
		for (const BorderPart& notch : notches)
			result.notches[panelOfPatch[patch]].push_back(onSurface(assembly, notch.halfEdges));
	}
}

/// \param otherwise  what is wrong where it does not hold
void judge(CutPanel& panel, bool holds, Reason otherwise, double limit) {
	panel.developable = holds && panel.maxDisplacement <= limit;
	const Reason why = holds ? Reason::TooFar : otherwise;
	panel.reason = panel.developable ? Reason::AsStatus : why;
}

/// Zero strain. \return whether all are developable and near; they may overlap themselves
bool judgeCurvature(const ConstrainedNewtonOptions& options, const std::vector<int>& panelOfPatch,
					const std::vector<double>& limits, SewnPanels& result) {
	bool all = true;
	for (const int panel : panelOfPatch) {
		CutPanel& report = result.panels[panel];
		const bool flat = report.curvatureAfter <= options.curvatureTolerance &&
						  report.maxAngleDefect <= options.angleTolerance;
		judge(report, flat, Reason::NeedsCut, limits[panel]);
		all = all && report.developable;
	}
	return all;
}

/// Strain within bounds.
void judgeStrain(const std::vector<PatternVerdict>& verdicts, const std::vector<int>& panelOfPatch,
				 const std::vector<double>& limits, std::vector<CutPanel>& panels) {
	for (std::size_t patch = 0; patch < verdicts.size(); ++patch) {
		CutPanel& report = panels[panelOfPatch[patch]];
		report.beyondBounds = verdicts[patch].beyondBounds;
		const bool beyond = report.beyondBounds > patternTolerance;
		judge(report, verdicts[patch].holds(), beyond ? Reason::BeyondBounds : Reason::NeedsCut,
			  limits[panelOfPatch[patch]]);
		if (beyond)
			report.worstPoint = verdicts[patch].worstPoint;
	}
}

/// On the level that the method begins on: finer ones follow it, and take most of the time. Patterns are
/// laid flat as fine as they are: whether borders cross is a matter of fractions of an edge.
void developCoarsely(const PatchAssembly& assembly, const CutSurface& surface,
					 ConstrainedNewtonOptions options, const std::vector<double>& limits, SewnPanels& result,
					 const Progress& progress) {
	const std::vector<int> panelOfPatch = panelsOfPatches(assembly, surface);
	const bool large = assembly.placeCount() > manyPlaces;
	const std::optional<PatchAssembly> smoothed =
		withoutDetail(assembly, *std::max_element(limits.begin(), limits.end()));
	const PatchAssembly& shape = smoothed ? *smoothed : assembly;
	const PartialAssembly coarse =
		coarserLevel(shape, large ? placesOfMany : options.tuning.coarsestTogether);
	std::vector<int> panelOfCoarsePatch;
	for (const int patch : coarse.wholePatch)
		panelOfCoarsePatch.push_back(panelOfPatch[patch]);
	options.tuning.separationSteps = 0; // borders are coarse, too
	options.tuning.preferredMove *= options.tuning.coarseRoom;
	options.tuning.preferredLength *= options.tuning.coarseRoom;
	Positions positions = coarse.assembly.originalPositions;
	result.work += constrainedNewton(coarse.assembly, positions, options, progress).work;
	measurePanels(coarse.assembly, positions, surface, panelOfCoarsePatch, limits, result);
	if (!judgeCurvature(options, panelOfCoarsePatch, limits, result))
		return;
	const Positions carried = carriedOver(shape, coarse, positions - coarse.assembly.originalPositions);
	// Little of what is seen here is there in the end, and the method moves most of that apart.
	std::vector<double> little = limits;
	for (double& length : little)
		length *= littleOverlap;
	refuseOverlaps(shape, shape.originalPositions + carried, surface, panelOfPatch, little, result);
}

/// With zero strain, as the user will. In single precision what came of it may be laid flat before it is
/// stored, or afterwards.
void developWholly(const PatchAssembly& assembly, const CutSurface& surface,
				   const ConstrainedNewtonOptions& options, const std::vector<double>& limits,
				   bool singlePrecision, SewnPanels& result, const Progress& progress) {
	const std::vector<int> panelOfPatch = panelsOfPatches(assembly, surface);
	Positions positions = assembly.originalPositions;
	result.work += constrainedNewton(assembly, positions, options, progress).work;
	measurePanels(assembly, positions, surface, panelOfPatch, limits, result);
	if (!judgeCurvature(options, panelOfPatch, limits, result))
		return;
	refuseOverlaps(assembly, positions, surface, panelOfPatch, {}, result);
	if (!singlePrecision || worstOf(result) >= 0)
		return;
	positions = rounded<float>(positions, assembly.lengthExponent);
	refuseOverlaps(assembly, positions, surface, panelOfPatch, {}, result);
}

/// With a material.
void developStrained(const PatchAssembly& assembly, const CutSurface& surface, const PanelMaterial& material,
					 bool brief, const std::vector<double>& limits, SewnPanels& result,
					 const Progress& progress) {
	const std::vector<int> panelOfPatch = panelsOfPatches(assembly, surface);
	const double maxDisplacement = ConstrainedNewtonOptions().maxDisplacement;
	Positions positions = assembly.originalPositions;
	const std::vector<PatternVerdict> verdicts =
		bringWithinBounds(assembly, positions, material, {maxDisplacement, 0, brief}, progress);
	result.work += workOnStrain * assembly.triangleCount();
	measurePanels(assembly, positions, surface, panelOfPatch, limits, result);
	judgeStrain(verdicts, panelOfPatch, limits, result.panels);
}

} // namespace

SewnPanels developSewnPanels(const TriangleMesh& mesh, const CutSurface& surface,
							 const std::vector<double>& maxDisplacement, const PanelMaterial& material,
							 double preferredMove, SewnRun run, const Progress& progress) {
	const bool brief = run == SewnRun::Brief;
	const PatchAssembly assembly = assemblePatches(mesh, {});
	SewnPanels result;
	result.panels.resize(surface.panelCount());
	if (markClosed(assembly, surface, result))
		return result;
	const std::vector<double> limits = limitsOfPanels(surface, maxDisplacement);
	ConstrainedNewtonOptions options;
	options.tuning.preferredMove = preferredMove;
	options.tuning.curvatureSteps = 0;
	if (material.bounds.any()) {
		developStrained(assembly, surface, material, brief, limits, result, progress);
		return result;
	}
	if (run == SewnRun::OneWay)
		options.tuning.otherLevels = 0;
	if (brief) {
		options.tuning.otherLevels = 1;
		options.tuning.preferredLength = *std::max_element(limits.begin(), limits.end());
		options.tuning.closerFrom = 1;
		options.tuning.closerReach = nearlyWithin;
	}
	result.provisional = brief;
	result.coarse =
		brief && !options.tuning.isCoarsest(assembly.placeCount(), options.tuning.coarsestTogether);
	if (result.coarse)
		developCoarsely(assembly, surface, options, limits, result, progress);
	else
		developWholly(assembly, surface, options, limits, mesh.singlePrecision, result, progress);
	return result;
}

SewnPanels overlapsOfShape(const TriangleMesh& mesh, const CutSurface& surface, const SewnPanels& shape) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	SewnPanels result;
	result.panels.resize(surface.panelCount());
	if (markClosed(assembly, surface, result))
		return result;
	Positions positions(3, assembly.placeCount());
	for (int corner = 0; corner < 3 * assembly.triangleCount(); ++corner)
		positions.col(assembly.placeAt(corner)) =
			shape.corners.col(3 * assembly.faceOfTriangle[triangleOf(corner)] + cornerInTriangle(corner));
	refuseOverlaps(assembly, positions, surface, panelsOfPatches(assembly, surface), {}, result);
	return result;
}

} // namespace developable::detail
