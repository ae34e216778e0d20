// SPDX-License-Identifier: GPL-3.0-or-later
// panel_tests.cpp: tests in parallel; a stop reaches them all.
#include "panel_tests.h"

namespace developable::detail {

namespace {

constexpr double shareAlone = 0.75;    ///< of the greatest displacement: what a panel may need by itself
constexpr double meanOfGreatest = 0.3; ///< mean displacement as a share of the greatest

/// What a verdict depends on, within a patch.
std::pair<std::vector<double>, std::vector<int>> keyOf(const TriangleMesh& panel) {
	return {{panel.positions.data(), panel.positions.data() + panel.positions.size()},
			{panel.triangles.data(), panel.triangles.data() + panel.triangles.size()}};
}

} // namespace

PanelTrial trialOf(const CutSurface& surface, const std::vector<int>& triangles) {
	return {surface.meshOf(triangles), surface.assembly().patchOfTriangle[triangles.front()]};
}

PanelTrial trialAcross(CutSurface& surface, const std::vector<int>& halfEdges) {
	for (const int h : halfEdges)
		surface.setCut(h, false);
	PanelTrial trial = trialOf(surface, surface.trianglesAtBothSides(halfEdges.front()));
	for (const int h : halfEdges)
		surface.setCut(h, true);
	return trial;
}

PanelTests::PanelTests(std::vector<double> maxDisplacement, const PanelMaterial& material, Progress progress)
	: maxDisplacement_(std::move(maxDisplacement)), material_(material), progress_(std::move(progress)) {}

PanelLimits PanelTests::limitsOf(int patch) const {
	const double greatest = scale_ * shareAlone * maxDisplacement_[patch];
	return {greatest, meanOfGreatest * greatest, material_};
}

void PanelTests::scaleLimits(double factor) {
	if (factor != scale_)
		known_.clear();
	scale_ = factor;
}

std::vector<PanelVerdict> PanelTests::test(const std::vector<PanelTrial>& trials) {
	std::vector<PanelVerdict> verdicts(trials.size());
	std::vector<Task> tasks;
	tasks.reserve(trials.size());
	for (std::size_t i = 0; i < trials.size(); ++i) {
		const auto known = known_.find(keyOf(trials[i].panel));
		if (known != known_.end()) {
			verdicts[i] = known->second;
			continue;
		}
		work_ += trials[i].panel.triangleCount();
		tasks.push_back({1, [&, i](const Progress& progress) {
							 if (!stopped_)
								 verdicts[i] =
									 testPanel(trials[i].panel, limitsOf(trials[i].patch), progress);
						 }});
	}
	runTasks(tasks, 0, [&](double, const std::string&) { return mayGoOn(fractionDone_, message_); });
	for (std::size_t i = 0; i < trials.size() && !stopped_; ++i)
		known_.emplace(keyOf(trials[i].panel), verdicts[i]);
	return verdicts;
}

bool PanelTests::areAllPanels(const std::vector<PanelTrial>& trials) {
	const std::vector<PanelVerdict> verdicts = test(trials);
	return std::all_of(verdicts.begin(), verdicts.end(),
					   [](const auto& verdict) { return verdict.isPanel(); }) &&
		   !stopped_;
}

bool PanelTests::mayGoOn(double fractionDone, const std::string& message) {
	fractionDone_ = std::max(fractionDone, fractionDone_);
	if (message_ != message)
		message_ = message;
	if (!stopped_ && !developable::mayGoOn(progress_, fractionDone_, message_))
		stopped_ = true;
	return !stopped_;
}

} // namespace developable::detail
