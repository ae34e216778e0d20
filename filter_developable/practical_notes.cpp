// SPDX-License-Identifier: GPL-3.0-or-later
// practical_notes.cpp: lays patches flat that are nearly developable.
#include "practical_notes.h"

#include "results.h"

#include "developable/flatten/flatten.h"

#include <algorithm>

namespace developable::plugin {

namespace {

constexpr double littleCurvature = 0.3; ///< rad, of a patch: it strains by a tenth at most when laid flat

bool isLeft(const PanelReport& panel) {
	return !converged(panel.verdict.status);
}

} // namespace

std::optional<double> strainLeft(const PatchAssembly& assembly, const Positions& positions,
								 const std::vector<PanelReport>& panels) {
	const auto hasMuch = [](const PanelReport& panel) {
		return isLeft(panel) && !(panel.after.curvature <= littleCurvature);
	};
	if (std::none_of(panels.begin(), panels.end(), isLeft) ||
		std::any_of(panels.begin(), panels.end(), hasMuch))
		return std::nullopt;
	try {
		const PartialAssembly left =
			partialAssembly(assembly, trianglesWhere(assembly.triangleCopies, [&](int triangle) {
								return isLeft(panels[std::size_t(assembly.patchOfTriangle[triangle])]);
							}));
		const Positions shape = positions(Eigen::all, left.wholePlace);
		return 100 * flattenPatches(left.assembly, shape, FlattenOptions()).report.maxEdgeStrain;
	} catch (const Error&) { // a patch with handles, or one that lost a triangle to rounding
		return std::nullopt;
	}
}

} // namespace developable::plugin
