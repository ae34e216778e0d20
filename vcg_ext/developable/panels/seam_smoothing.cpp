// SPDX-License-Identifier: GPL-3.0-or-later
// seam_smoothing.cpp: first what moves seams least, then what makes them smooth.
#include "seam_smoothing.h"

#include "sewn_failures.h"

#include <utility>

namespace developable::detail {

SeamSmoothing::SeamSmoothing(PlannedSurface& planned, const std::vector<int>& clusters,
							 const std::vector<Eigen::Vector3d>& dartTips, const CutOptions& options,
							 const MirrorPlane* mirror, SewingSteps steps)
	: planned_(planned), before_(planned),
	  taut_(before_, clusters, dartTips, options, sharpFeatures(before_.surface, options.creaseAngle)),
	  smooth_(taut_), mirror_(mirror), steps_(std::move(steps)), safest_(planned) {}

bool SeamSmoothing::holds(const SewnPanels& sewn) const {
	return planned_.surface.usedPanelCount() <= before_.surface.usedPanelCount() && worstOf(sewn) < 0;
}

SewnPanels SeamSmoothing::run(SeamDrawing::Manner smoothest) {
	constexpr int rounds = 4;
	planned_ = taut_.drawn(); // it is not taut yet: what moves seams least
	SewnPanels sewn = steps_.relieve(steps_.sew());
	safest_ = planned_;
	if (!holds(sewn))
		return sewn;
	taut_.draw(SeamDrawing::Manner::Taut);
	smooth_.draw(SeamDrawing::Manner::Smooth);
	const bool taut = tryDrawing(taut_, 1, sewn);
	const bool smooth = smoothest == SeamDrawing::Manner::Smooth && tryDrawing(smooth_, rounds, sewn);
	if (!smooth && !taut)
		tryDrawing(taut_, rounds - 1, sewn); // it is less taut by now where it failed
	return sewn;
}

/// Where panels do not hold seams move less in each round. \return whether the surface has such seams now,
/// which are shorter than before
bool SeamSmoothing::tryDrawing(SeamDrawing& drawing, int rounds, SewnPanels& sewn) {
	const double length = seamLength(planned_.surface);
	for (int round = 0; round < rounds && steps_.mayGoOn(); ++round) {
		PlannedSurface before = std::exchange(planned_, drawing.drawn());
		if (seamLength(planned_.surface) >= length) {
			planned_ = std::move(before);
			return false;
		}
		SewnPanels smoother = steps_.close(steps_.sew());
		if (holds(smoother)) {
			sewn = std::move(smoother);
			return true;
		}
		planned_ = std::move(before);
		std::vector<Eigen::Vector3d> worst = worstPoints(smoother);
		for (std::size_t i = 0, count = worst.size(); i < count && mirror_ != nullptr; ++i)
			worst.push_back(mirror_->mirrored(worst[i]));
		if (!drawing.tightenAt(worst))
			return false;
	}
	return false;
}

} // namespace developable::detail
