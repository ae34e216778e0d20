// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_panels.cpp: one run of the constrained Newton method, read panel by panel.
#include "sewn_panels.h"

#include "developable/flatten/flatten.h"
#include "developable/newton/constrained_newton.h"

#include <algorithm>

namespace developable::detail {

namespace {

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
		panel.maxDisplacement = boxDiagonal(surface.positions());
		panel.curvatureAfter = 4 * pi; // of a closed surface it is never less
	}
	return any;
}

/// Panels that overlap themselves when laid flat are none, however developable.
void refuseOverlaps(const PatchAssembly& assembly, const Positions& positions,
					const std::vector<int>& panelOfPatch, std::vector<CutPanel>& panels) {
	const FlatPatterns patterns = flattenPatches(assembly, positions);
	for (std::size_t patch = 0; patch < patterns.pieces.size(); ++patch)
		if (patterns.pieces[patch].overlapping)
			panels[panelOfPatch[patch]].developable = false;
}

} // namespace

SewnPanels developSewnPanels(const TriangleMesh& mesh, const CutSurface& surface,
							 const std::vector<double>& maxDisplacement, bool brief,
							 const Progress& progress) {
	const PatchAssembly assembly = assemblePatches(mesh, {});
	SewnPanels result;
	result.panels.resize(surface.panelCount());
	if (markClosed(assembly, surface, result))
		return result;
	Positions positions = assembly.originalPositions;
	const Eigen::VectorXd before = angleDefects(assembly, positions);
	ConstrainedNewtonOptions options;
	if (brief)
		options.tuning.attempts = 1;
	const ConstrainedNewtonReport run = constrainedNewton(assembly, positions, options, progress);
	const Eigen::VectorXd after = angleDefects(assembly, positions);
	const Eigen::VectorXd moves = displacementMap(assembly.originalPositions, positions);

	result.status = run.status;
	result.meanDisplacement = moves.mean();
	result.maxDisplacement = moves.maxCoeff();
	std::vector<int> panelOfPatch(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		panelOfPatch[assembly.patchOfTriangle[t]] = surface.panelOf(assembly.faceOfTriangle[t]);
	const auto patchOf = [&](int panel) {
		return surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()];
	};
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
		// What is moved too far counts first.
		const double far = moves[place] > maxDisplacement[patchOf(panel)] ? 1e3 * moves[place] : 0;
		if (std::abs(after[copy]) + far > worst[panel]) {
			worst[panel] = std::abs(after[copy]) + far;
			report.worstPoint = assembly.originalPositions.col(place);
		}
	}
	for (int panel = 0; panel < surface.panelCount(); ++panel) {
		CutPanel& report = result.panels[panel];
		report.triangles = static_cast<int>(surface.trianglesOf(panel).size());
		if (report.triangles == 0)
			continue;
		report.area = surface.area(panel);
		report.meanDisplacement /= copies[panel];
		report.developable = report.curvatureAfter <= options.curvatureTolerance &&
							 report.maxAngleDefect <= options.angleTolerance &&
							 report.maxDisplacement <= maxDisplacement[patchOf(panel)];
	}
	if (std::all_of(result.panels.begin(), result.panels.end(),
					[](const CutPanel& panel) { return panel.triangles == 0 || panel.developable; }))
		refuseOverlaps(assembly, positions, panelOfPatch, result.panels);
	return result;
}

} // namespace developable::detail
