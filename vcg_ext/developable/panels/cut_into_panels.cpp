// SPDX-License-Identifier: GPL-3.0-or-later
// cut_into_panels.cpp: the order of the work, from patches to panels that are sewn together.
#include "cut_into_panels.h"

#include "canonical_form.h"
#include "displacement_limits.h"
#include "found_panels.h"
#include "given_parts.h"
#include "normal_clusters.h"
#include "panel_plan.h"

#include <algorithm>

namespace developable {

namespace detail {

namespace {

/// Where there are more, one search takes long, and is made where the surface is.
constexpr int mostTrianglesOfForms = 2000;

CutOptions optionsOf(const CanonicalForm& form, const CutOptions& options) {
	CutOptions result = options;
	const Grain& grain = options.material.grain;
	if (!grain.alongSeam())
		result.material.grain = Grain(form.directionInForm(grain.direction()));
	return result;
}

std::vector<double> limitsOf(const GivenPatches& given, const CutOptions& options) {
	return displacementLimits(assemblePatches(given.mesh, {}), options.maxDisplacement);
}

CutResult stoppedResult() {
	CutResult result;
	result.report.status = Status::Stopped;
	return result;
}

/// Panels are found on the canonical form of what was given, and judged on both. They may move a little less
/// on the form: what just holds there holds here, too, although roundings differ.
CutResult cutForm(const GivenPatches& given, const CutOptions& options, const Progress& progress) {
	constexpr double lessRoom = 0.999;
	const CanonicalForm form(given);
	std::vector<double> limits = displacementLimits(form, options.maxDisplacement);
	const std::vector<double> limitsHere = limitsOf(given, options);
	PanelPlan here({given, limitsHere, options}, progress);
	for (double& limit : limits)
		limit *= lessRoom;
	const auto find = options.symmetric ? findSymmetricPanels : findPanels;
	FoundPanels found = find({form.patches(), limits, optionsOf(form, options)}, progress);
	if (found.stopped)
		return stoppedResult();
	std::vector<PlannedSurface> carried;
	carried.reserve(found.planned.size());
	for (const PlannedSurface& planned : found.planned)
		carried.push_back(form.carriedBack(planned));
	if (!here.takeOver(carried) && found.hold) {
		here.divide();
		if (options.symmetric && found.notes.empty())
			found.notes.emplace_back(noteOnDivided);
	}
	here.explain();
	CutResult result = here.result();
	result.report.notes.insert(result.report.notes.end(), found.notes.begin(), found.notes.end());
	return result;
}

CutResult cutAsItIs(const GivenPatches& given, const CutOptions& options, const Progress& progress) {
	const std::vector<double> limits = limitsOf(given, options);
	FoundPanels found = findPanels({given, limits, options}, progress);
	if (found.stopped)
		return stoppedResult();
	PanelPlan plan({given, limits, options}, progress);
	plan.takeOver(std::move(found.planned.front()), std::move(found.sewn));
	plan.explain();
	return plan.result();
}

CutResult cutPatches(const GivenPatches& given, const CutOptions& options, const Progress& progress) {
	const bool asForm = options.symmetric || given.mesh.triangleCount() <= mostTrianglesOfForms;
	return (asForm ? cutForm : cutAsItIs)(given, options, progress);
}

/// Side by side: they have no bearing on each other, unless all of them together are to have so many panels
/// or to mirror each other.
CutResult cutParts(const GivenPatches& given, const CutOptions& options, const Progress& progress) {
	if (options.maxPanels > 0 || options.symmetric)
		return cutPatches(given, options, progress);
	const std::vector<GivenPatches> parts = partsOf(given);
	if (parts.size() == 1)
		return cutPatches(given, options, progress);
	if (!mayGoOn(progress, 0, "cutting " + std::to_string(parts.size()) + " parts"))
		return stoppedResult(); // small parts end before anybody asks
	std::vector<CutResult> results(parts.size());
	std::vector<Task> tasks;
	for (std::size_t i = 0; i < parts.size(); ++i)
		tasks.push_back({double(parts[i].mesh.triangleCount()), [&, i](const Progress& ofPart) {
							 results[i] = cutPatches(parts[i], options, neverBack(ofPart));
						 }});
	runTasks(tasks, 0, progress);
	const auto wasStopped = [](const CutResult& result) { return result.report.status == Status::Stopped; };
	if (std::any_of(results.begin(), results.end(), wasStopped))
		return stoppedResult();
	return putTogether(parts, results);
}

} // namespace

} // namespace detail

CutResult cutIntoPanels(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
						const Progress& progress) {
	requireOption(options.maxPanels >= 0, "The largest number of panels must be 0 or more.");
	requireOption(options.creaseAngle >= 0 && options.creaseAngle <= 180,
				  "The crease angle must be between 0 and 180 degrees.");
	requireOption(!std::isnan(options.maxDisplacement) && !std::isinf(options.maxDisplacement),
				  "The greatest displacement must be a number.");
	requireValid(options.material.bounds);
	return detail::cutParts(detail::separatePatches(mesh, patches), options, neverBack(progress));
}

} // namespace developable
