// SPDX-License-Identifier: GPL-3.0-or-later
// panel_sewing.cpp: what is sewn, with what bound, and what came of it before.
#include "panel_sewing.h"

#include "displacement_limits.h"
#include "sewn_failures.h"

#include "developable/newton/constrained_newton.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace developable::detail {

namespace {

constexpr double workAround = 20; ///< a run, on a triangle that is put in place and laid flat

/// As the constrained Newton method will prefer it where the user runs it. Limits by default are the same
/// along any axes, and so what is preferred is here.
double preferredMove(const PatchAssembly& assembly, const std::vector<double>& limits,
					 const CutOptions& options) {
	const double share = ConstrainedNewtonOptions().tuning.preferredMove;
	if (options.maxDisplacement >= 0)
		return share;
	const std::vector<double> alongAxes = displacementLimits(assembly, options.maxDisplacement);
	double least = 1;
	for (std::size_t patch = 0; patch < limits.size(); ++patch)
		least = std::min(least, limits[patch] / alongAxes[patch]);
	return least * share;
}

} // namespace

bool PanelSewing::Asked::operator==(const Asked& other) const {
	return std::tie(panels, triangles, positions) == std::tie(other.panels, other.triangles, other.positions);
}

PanelSewing::PanelSewing(const GivenPatches& given, const std::vector<double>& limits,
						 const CutOptions& options, PanelTests& tests)
	: given_(given), limits_(limits), options_(options), tests_(tests),
	  preferredMove_(preferredMove(assemblePatches(given.mesh, {}), limits, options)) {}

TriangleMesh PanelSewing::meshOfUser(const PlannedSurface& planned) const {
	TriangleMesh mesh = meshAsCut(planned, given_.vertexTaken);
	mesh.singlePrecision = given_.mesh.singlePrecision;
	if (mesh.singlePrecision)
		mesh.positions = rounded<float>(mesh.positions, mesh.lengthExponent);
	return mesh;
}

void PanelSewing::lessRoomAfter(const SewnPanels& sewn, const CutSurface& surface) {
	constexpr double least = 0.8, leastFactor = 0.85;
	double farthest = 1; // share of the limit
	for (int panel = 0; panel < surface.panelCount(); ++panel)
		if (const CutPanel& report = sewn.panels[panel]; report.reason == Reason::TooFar) {
			const int patch = surface.assembly().patchOfTriangle[surface.trianglesOf(panel).front()];
			farthest = std::max(farthest, report.maxDisplacement / limits_[patch]);
		}
	if (farthest == 1)
		return;
	briefRoom_ = std::max(least, briefRoom_ * std::max(leastFactor, 1 / farthest));
	seen_.erase(std::remove_if(seen_.begin(), seen_.end(), [](const Seen& seen) { return seen.brief; }),
				seen_.end());
}

SewnPanels PanelSewing::sew(const PlannedSurface& planned, bool brief) {
	const TriangleMesh mesh = meshOfUser(planned);
	Asked asked{{mesh.positions.data(), mesh.positions.data() + mesh.positions.size()},
				{mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size()},
				planned.surface.panels()};
	for (const Seen& seen : seen_)
		if (seen.asked == asked && serves(seen, brief))
			return seen.sewn;
	work_ += workAround * mesh.triangleCount();
	const double room = brief ? briefRoom_ : 1;
	std::vector<double> limits = limits_;
	for (double& limit : limits)
		limit *= room;
	const SewnRun whole = waysLeft_ > 0 ? SewnRun::Whole : SewnRun::OneWay;
	SewnPanels sewn =
		developSewnPanels(mesh, planned.surface, limits, options_.material, room * preferredMove_,
						  brief ? SewnRun::Brief : whole, [&](double, const std::string&) {
							  return tests_.mayGoOn(0.7, "sewing the panels together");
						  });
	work_ += sewn.work;
	if (tests_.stopped())
		return sewn;
	if (!brief) {
		if (worstOf(sewn) >= 0 && !onlyOverlap(sewn))
			--waysLeft_;
		lessRoomAfter(sewn, planned.surface);
	}
	if (seen_.size() == mostSeen)
		seen_.pop_front();
	seen_.push_back({std::move(asked), brief, sewn});
	return sewn;
}

} // namespace developable::detail
