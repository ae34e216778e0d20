// SPDX-License-Identifier: GPL-3.0-or-later
// panel_material.cpp: bounded strain and patterns within bounds, as far as a cut needs them.
#include "panel_material.h"

#include "developable/bounded_strain/bounded_strain.h"
#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

constexpr int briefSteps = 40;       ///< hardly any panel that holds takes more
constexpr double shareOfBound = 0.8; ///< mean strain of what holds without moving

double greatestBound(const StrainBounds& bounds) {
	double greatest = 0;
	for (const DirectionBounds& direction : {bounds.warp, bounds.weft, bounds.bias})
		greatest = std::max({greatest, direction.stretch, direction.compression});
	return greatest;
}

FlatPatterns patternsWithin(const PatchAssembly& assembly, const Positions& positions,
							const PanelMaterial& material) {
	FlattenOptions options;
	options.bounds = material.bounds;
	options.grain = material.grain;
	return flattenPatches(assembly, positions, options);
}

} // namespace

Outlook outlookOf(const PatchAssembly& panel, const PanelMaterial& material, double maxDisplacement) {
	const FlatPatterns patterns = flattenPatches(panel, panel.originalPositions);
	double area = 0;
	for (const auto& places : panel.trianglePlaces.colwise())
		area += triangleFrame(panel.originalPositions, places).normal.norm() / 2;
	const double movedAway = maxDisplacement / (3 * std::sqrt(area / pi));
	const double strain = patterns.report.meanEdgeStrain, bound = greatestBound(material.bounds);
	if (patterns.pieces.front().overlapping || strain > shareOfBound * bound + movedAway)
		return Outlook::Hopeless;
	return strain > bound ? Outlook::MostlyMoves : Outlook::MostlyStrains;
}

std::vector<PatternVerdict> bringWithinBounds(const PatchAssembly& assembly, Positions& positions,
											  const PanelMaterial& material, const BoundedSearch& search,
											  const Progress& progress) {
	BoundedStrainOptions options;
	options.bounds = material.bounds;
	options.grain = material.grain;
	options.smoothness = material.smoothness;
	options.maxDisplacement = search.maxDisplacement;
	options.meanOnWay = search.meanOnWay;
	options.searchBeyond = false;
	options.severalStarts = !search.brief;
	if (search.brief)
		options.maxIterations = briefSteps;
	FlatPatterns patterns = boundedStrain(assembly, positions, options, progress).patterns;
	if (patterns.pieces.empty()) // of several parts
		patterns = patternsWithin(assembly, positions, material);
	std::vector<PatternVerdict> verdicts;
	verdicts.reserve(patterns.pieces.size());
	for (const FlatPiece& piece : patterns.pieces) {
		PatternVerdict verdict;
		verdict.beyondBounds = piece.beyondBounds;
		verdict.usable = !piece.overlapping && piece.cuts == 0 && piece.flippedFaces == 0;
		if (piece.worstTriangle >= 0)
			verdict.worstPoint = barycentre(positions, assembly.trianglePlaces.col(piece.worstTriangle));
		verdicts.push_back(verdict);
	}
	return verdicts;
}

} // namespace developable::detail
