// SPDX-License-Identifier: GPL-3.0-or-later
// still_plan.cpp: the stages of the work where nothing has to move.
#include "panel_plan.h"

#include "first_panels.h"
#include "seam_drawing.h"
#include "sewn_failures.h"
#include "symmetric_joining.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

namespace {

constexpr double still = 0.02; ///< share of what may move: what is more was made to

} // namespace

bool PanelPlan::clusterStill() {
	if (!tests_->mayGoOn(0, "looking for creases"))
		return false;
	creases_ = makeStillPanels(planned_, *tests_, options_, still);
	clusters_ = planned_.surface.panels();
	return creases_.has_value();
}

bool PanelPlan::searchStill() {
	if (!clusterStill())
		return false;
	join();
	sewn_ = sewTogether(false);
	if (tests_->stopped() || worstOf(sewn_) >= 0)
		return false;
	straighten();
	return finish();
}

/// What a crease encloses mirrors what its mirror image encloses: only joins across creases have to go in
/// pairs.
bool PanelPlan::searchStill(const MirrorPlane& plane) {
	if (!clusterStill())
		return false;
	joinBetween(*creases_);
	joinSymmetrically(planned_.surface, *tests_, history_, plane, mirroredTriangles(planned_.mesh, plane));
	sewn_ = sewTogether(false);
	return !tests_->stopped() && worstOf(sewn_) < 0;
}

/// Slits, and what else is on no sharp edge.
void PanelPlan::straighten() {
	const PlannedSurface before = planned_;
	SeamDrawing drawing(before, clusters_, dartTips_, options_, *creases_);
	drawing.draw(SeamDrawing::Manner::Taut);
	planned_ = drawing.drawn();
	SewnPanels sewn = sewTogether(false);
	if (worstOf(sewn) < 0 &&
		sewn.maxDisplacement <= std::max(sewn_.maxDisplacement, tests_->limitsOf(0).maxDisplacement) &&
		planned_.surface.usedPanelCount() <= before.surface.usedPanelCount() &&
		seamLength(planned_.surface) < seamLength(before.surface))
		sewn_ = std::move(sewn);
	else
		planned_ = before;
}

} // namespace developable::detail
