// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.cpp: the stages of the work.
#include "panel_plan.h"

#include "crease_regions.h"
#include "cut_report.h"
#include "first_panels.h"
#include "panel_dissolving.h"
#include "panel_joining.h"
#include "seam_drawing.h"
#include "seam_reasons.h"
#include "seam_smoothing.h"
#include "selected_whole.h"
#include "sewn_failures.h"
#include "sewn_panels.h"
#include "sewn_relief.h"
#include "small_panels.h"

#include <cmath>
#include <utility>

namespace developable::detail {

PanelPlan::PanelPlan(const SearchInput& input, const Progress& progress)
	: options_(input.options), given_(input.patches), planned_{given_.mesh, given_.origins,
															   CutSurface(assemblePatches(given_.mesh, {}))},
	  confirms_(input.confirmed) {
	tests_ = std::make_unique<PanelTests>(input.limits, options_.material, progress);
	sewing_ = std::make_unique<PanelSewing>(given_, input.limits, options_, *tests_);
}

bool PanelPlan::mayTry() const {
	constexpr double workOnCoarse = 2e7, perTriangle = 1.2e4; // some twenty runs there, a few on the surface
	return work() - workOnJoining_ < workOnCoarse + perTriangle * given_.mesh.triangleCount();
}

SewnPanels PanelPlan::sewTogether(bool brief) {
	return sewing_->sew(planned_, brief);
}

/// What holds briefly may not as the user will have it: then overlaps are closed, and darts cut, where it
/// does not, as far as it holds briefly with these, too.
SewnPanels PanelPlan::confirmed(SewnPanels sewn) {
	constexpr int attempts = 3;
	for (int attempt = 1; confirms_ && sewn.provisional && worstOf(sewn) < 0 && !tests_->stopped();
		 ++attempt) {
		sewn = sewTogether(false);
		if (attempt < attempts)
			sewn = relieved(std::move(sewn), true);
	}
	return sewn;
}

/// Sewn together, panels pull at each other.
SewnExcess PanelPlan::sewnExcess() {
	return [this] { return totalExcess(sewTogether(true)); };
}

/// Where some panels do not hold after that, what did before is the better.
SewnPanels PanelPlan::joinedWithDarts() {
	if (tests_->stopped() || !options_.darts || !options_.splitTriangles || !mayTry())
		return divideUntilAllHold();
	const PlannedSurface before = planned_;
	joinWithDarts(planned_.surface, *tests_, sewnExcess());
	SewnPanels sewn = confirmed(relieved(sewTogether(true), true));
	if (worstOf(sewn) < 0 || tests_->stopped())
		return sewn;
	planned_ = before;
	return divideUntilAllHold();
}

const std::vector<int>& PanelPlan::cluster(double deviation) {
	makeFirstPanels(planned_, *tests_, options_, deviation);
	clusters_ = planned_.surface.panels();
	return clusters_;
}

/// Across seams that lie on none of some creases.
void PanelPlan::joinBetween(const SharpFeatures& creases) {
	joinPanels(planned_.surface, *tests_, history_, [&](const SeamChain& chain) {
		return mayJoinOn() && !liesOnCrease(chain, planned_.surface, creases);
	});
}

/// Of shapes with limbs and fine detail the last few panels would take longer than all before.
bool PanelPlan::mayJoinOn() const {
	constexpr double mostWork = 2e7; // a good half minute
	return tests_->work() < mostWork;
}

void PanelPlan::joinGreedily() {
	joinBetween(sharpFeatures(planned_.surface, options_.creaseAngle));
	joinPanels(planned_.surface, *tests_, history_, [this](const SeamChain&) { return mayJoinOn(); });
	joinedGreedily_ = planned_;
}

SewnPanels PanelPlan::sewnAtFirst() {
	const PlannedSurface joined = planned_;
	planned_ = SeamDrawing(joined, clusters_, dartTips_, options_,
						   sharpFeatures(joined.surface, options_.creaseAngle))
				   .drawn();
	SewnPanels sewn = sewTogether(true);
	planned_ = joined;
	return sewn;
}

void PanelPlan::join() {
	if (!joinedGreedily_)
		joinGreedily();
	dissolvePanels(planned_.surface, clusters_, *tests_, history_);
	if (options_.darts && options_.splitTriangles)
		joinWithRelief(planned_.surface, *tests_, history_, dartTips_, keptTriangles(planned_, options_));
}

/// As few panels as can be, if these hold when they are sewn together, or soon do; else those that were
/// joined greedily, which are more and hold sooner.
void PanelPlan::sewJoined() {
	constexpr int roundsOfFew = 8, rounds = 12;
	const bool fewer = planned_.surface.usedPanelCount() < joinedGreedily_->surface.usedPanelCount();
	if (sewUntilAllHold(fewer ? roundsOfFew : rounds) || !fewer || tests_->stopped() || !mayTry())
		return;
	planned_ = *joinedGreedily_;
	dartTips_.clear();
	sewUntilAllHold(rounds);
}

/// Panels that hold by themselves may not when they are sewn together with smooth seams: then the last joins
/// of those that do not are taken back, and halves may go to others. \return whether all hold
bool PanelPlan::sewUntilAllHold(int rounds) {
	constexpr double tighter = 0.95; // with every round: panels with more room hold sooner
	reliefsLeft_ = workOnReliefs;
	closingsLeft_ = workOnClosings;
	std::vector<char> mayJoin(clusters_.size(), 0);
	for (int round = 1; !tests_->stopped(); ++round) {
		tests_->scaleLimits(room_ * std::pow(tighter, round - 1));
		joinPanels(planned_.surface, *tests_, history_, [&](const SeamChain& chain) {
			const int h = chain.halfEdges.front();
			return mayTry() &&
				   (mayJoin[triangleOf(h)] || mayJoin[triangleOf(planned_.surface.assembly().across(h))]);
		});
		if (tests_->stopped() || seamChains(planned_.surface).empty())
			return true;
		if (!isPromising())
			return false;
		joinSlivers(planned_.surface, *tests_, history_);
		const PlannedSurface joined = planned_;
		const std::vector<Eigen::Vector3d> dartTips = dartTips_;
		growSmallPanels(planned_.surface, *tests_, keptTriangles(planned_, options_));
		const SewnPanels sewn = smoothSeams();
		if (worstOf(sewn) < 0) {
			held_ = {planned_, joined, dartTips_};
			return true;
		}
		PlannedSurface divided = joined;
		mayJoin = divideFailing(divided, sewn);
		if (round == rounds || tests_->stopped() || mayJoin.empty() || !mayTry())
			return false;
		planned_ = std::move(divided);
		dartTips_ = dartTips;
	}
	return false;
}

ClosingSteps PanelPlan::closingSteps() {
	return {[this] {
				SewnPanels sewn = sewTogether(true);
				closingsLeft_ -= sewn.work;
				return sewn;
			},
			[this](const SewnPanels& shape) { return sewing_->look(planned_, shape); },
			[this] { return !tests_->stopped() && closingsLeft_ > 0; }};
}

/// With overlaps closed, and darts, where that makes all hold.
SewnPanels PanelPlan::relieved(SewnPanels sewn, bool darts) {
	if (mirror_ != nullptr || worstOf(sewn) < 0)
		return sewn;
	const CutSurface start = planned_.surface;
	SewnPanels now = closeOverlaps(planned_.surface, keptTriangles(planned_, options_), sewn, closingSteps());
	if (worstOf(now) >= 0 && darts)
		now = withDarts(std::move(now));
	if (worstOf(now) < 0)
		return now;
	planned_.surface = start;
	return sewn;
}

SewnPanels PanelPlan::withDarts(SewnPanels sewn) {
	constexpr std::size_t mostFailing = 3; // else panels are too large, and not just a little
	if (!options_.darts || !options_.splitTriangles || !mayTry() || worstFirst(sewn).size() > mostFailing)
		return sewn;
	return SewnRelief(planned_, options_, *tests_, dartTips_, reliefsLeft_,
					  [this] { return sewTogether(true); })
		.relieved(std::move(sewn));
}

SewnPanels PanelPlan::smoothSeams(SeamDrawing::Manner smoothest) {
	const SewingSteps steps{[this] { return sewTogether(true); },
							[this](SewnPanels sewn) { return relieved(std::move(sewn), false); },
							[this](SewnPanels sewn) { return relieved(std::move(sewn), true); },
							[this] { return !tests_->stopped() && mayTry(); }};
	SeamSmoothing drawings(planned_, clusters_, dartTips_, options_, mirror_, steps);
	const SewnPanels drawn = drawings.run(smoothest);
	lessSmooth_.emplace(drawings.safest());
	SewnPanels sewn = confirmed(drawn);
	if (worstOf(drawn) >= 0 || worstOf(sewn) < 0 || tests_->stopped())
		return sewn;
	planned_ = drawings.safest();
	return confirmed(drawn);
}

bool PanelPlan::search(std::function<bool(const CutSurface&)> isPromising) {
	isPromising_ = std::move(isPromising);
	workOnJoining_ = work();
	sewJoined();
	if (!this->isPromising())
		return false;
	sewn_ = joinedWithDarts();
	return finish();
}

/// What is left to do where all hold. \return whether they still do
bool PanelPlan::finish() {
	absorbSmallPanels();
	if (options_.maxPanels > 0 && planned_.surface.usedPanelCount() > options_.maxPanels) {
		joinToSoFew();
		sewn_ = sewTogether(false);
	}
	return worstOf(sewn_) < 0;
}

std::vector<PlannedSurface> PanelPlan::found() const {
	std::vector<PlannedSurface> all = {planned_};
	if (worstOf(sewn_) < 0 && lessSmooth_)
		all.push_back(*lessSmooth_);
	all.insert(all.end(), earlier_.begin(), earlier_.end());
	return all;
}

bool PanelPlan::takeOver(const std::vector<PlannedSurface>& found) {
	SewnPanels first;
	for (std::size_t i = 0; i < found.size() && !tests_->stopped(); ++i) {
		planned_ = found[i];
		sewn_ = sewTogether(false);
		if (worstOf(sewn_) < 0)
			return true;
		if (i == 0)
			first = sewn_;
	}
	planned_ = found.front();
	sewn_ = std::move(first);
	return false;
}

void PanelPlan::takeOver(CarriedPanels found) {
	planned_ = std::move(found.planned);
	clusters_ = std::move(found.clusters);
}

bool PanelPlan::finishTakenOver() {
	sewn_ = smoothSeams(SeamDrawing::Manner::Taut);
	if (worstOf(sewn_) >= 0)
		sewn_ = divideUntilAllHold();
	return finish();
}

bool PanelPlan::divide() {
	sewn_ = divideUntilAllHold();
	return worstOf(sewn_) < 0;
}

void PanelPlan::takeOver(PlannedSurface found, SewnPanels sewn) {
	planned_ = std::move(found);
	sewn_ = std::move(sewn);
}

void PanelPlan::explain() {
	explainSeams(planned_.surface, *tests_, sewn_);
}

CutResult PanelPlan::result() const {
	CutResult result;
	if (stopped()) {
		result.report.status = Status::Stopped;
		return result;
	}
	result.report = reportOf(planned_.surface, sewn_, given_.seamLength, options_);
	result.mesh = cutMesh(planned_, given_.vertexTaken);
	return result;
}

/// At the price of larger displacements.
void PanelPlan::joinToSoFew() {
	constexpr int doublings = 4;
	for (int i = 0;
		 i < doublings && !tests_->stopped() && planned_.surface.usedPanelCount() > options_.maxPanels; ++i) {
		tests_->scaleLimits(std::pow(2, i + 1));
		history_.tryAllAgain();
		joinPanels(planned_.surface, *tests_, history_);
		if (options_.darts && options_.splitTriangles)
			joinWithDarts(planned_.surface, *tests_, sewnExcess());
	}
}

} // namespace developable::detail
