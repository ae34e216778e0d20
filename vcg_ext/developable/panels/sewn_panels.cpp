// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_panels.cpp: one run of the constrained Newton method, read panel by panel.
#include "sewn_panels.h"

#include "developable/newton/constrained_newton.h"

#include <numeric>

namespace developable::detail {

SewnPanels developSewnPanels(const CutSurface& surface, const std::vector<double>& maxDisplacement,
							 const Progress& progress) {
	std::vector<int> all(surface.assembly().triangleCount());
	std::iota(all.begin(), all.end(), 0);
	const PatchAssembly assembly = assemblePatches(surface.meshOf(all), {});
	Positions positions = assembly.originalPositions;
	const Eigen::VectorXd before = angleDefects(assembly, positions);
	const ConstrainedNewtonOptions options;
	const ConstrainedNewtonReport run = constrainedNewton(assembly, positions, options, progress);
	const Eigen::VectorXd after = angleDefects(assembly, positions);
	const Eigen::VectorXd moves = displacementMap(assembly.originalPositions, positions);

	SewnPanels result;
	result.status = run.status;
	result.meanDisplacement = moves.mean();
	result.maxDisplacement = moves.maxCoeff();
	result.panels.resize(surface.panelCount());
	std::vector<int> panelOfPatch(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		panelOfPatch[assembly.patchOfTriangle[t]] = surface.panelOf(t);
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
	return result;
}

} // namespace developable::detail
