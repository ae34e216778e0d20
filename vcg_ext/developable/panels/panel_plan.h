// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.h: from patches to panels: clusters, joining, smooth seams, darts, and all sewn together.
#pragma once

#include "cut_into_panels.h"
#include "mirror_plane.h"
#include "overlap_closing.h"
#include "panel_joining.h"
#include "panel_sewing.h"
#include "planned_surface.h"
#include "seam_drawing.h"
#include "search_input.h"
#include "sharp_features.h"
#include "thinned_patches.h"

#include <functional>
#include <memory>
#include <optional>

namespace developable::detail {

/// All panels mirror each other and hold; some had to be divided, and all hold; or some do not.
enum class SymmetricOutcome { Pairs, Divided, Fails };

class PanelPlan {
public:
	PanelPlan(const SearchInput& input, const Progress& progress);

	/// Makes the clusters that joining begins with.
	/// \param deviation  as in ClusterOptions: how coarse they are
	/// \return           per triangle
	const std::vector<int>& cluster(double deviation);

	/// Joins clusters to panels that hold by themselves, as long as that goes.
	void joinGreedily();
	/// What becomes of panels as they are when they are sewn together, seen briefly, with the safest of
	/// seams.
	SewnPanels sewnAtFirst();
	/// Joins clusters greedily, unless that is done, and then to fewer panels.
	void join();

	/// Finds panels that hold when they are sewn together, after these were joined.
	/// \param isPromising  asked before all are sewn together: where it says no the search is given up
	/// \return             whether all hold
	bool search(std::function<bool(const CutSurface&)> isPromising = {});

	/// The same from clusters on, without join(): panels get more room from stage to stage, and at the end of
	/// each all hold sewn together. What one stage can't do any more is what the one before came to.
	bool searchInStages();

	/// Panels whose seams lie on sharp edges of a surface that is developable between these: nothing moves,
	/// or hardly. \return whether there are such panels, and all hold
	bool searchStill();
	/// The same with joins that mirror each other.
	bool searchStill(const MirrorPlane& plane);

	/// Finds panels that mirror each other and hold when they are sewn together, without darts. Where some do
	/// not hold in the end they are divided, and then do not mirror each other any more.
	SymmetricOutcome searchSymmetric(const MirrorPlane& plane);

	/// Takes over panels that were found on another copy of the patches: the first that hold, else the first.
	/// \param found  not empty
	/// \return       whether they hold here, too
	bool takeOver(const std::vector<PlannedSurface>& found);

	/// Takes over panels that were found on another copy of the patches with fewer triangles.
	void takeOver(CarriedPanels found);
	/// Draws their seams anew, and divides what does not hold here. \return whether all hold
	bool finishTakenOver();

	/// Divides what does not hold. \return whether all hold
	bool divide();

	/// Takes over panels that were found on these patches.
	void takeOver(PlannedSurface found, SewnPanels sewn);

	/// Finds out why each panel has its longest seam.
	void explain();

	const PlannedSurface& planned() const { return planned_; }
	const SewnPanels& sewn() const { return sewn_; }
	/// What was found, the same with seams that are less smooth, which holds just as well, and what had more
	/// panels and held before.
	std::vector<PlannedSurface> found() const;
	bool stopped() const { return tests_->stopped(); }
	/// What testing and sewing took, in units of WorkBudget.
	double work() const { return tests_->work() + sewing_->work(); }
	CutResult result() const;

private:
	bool finish();
	bool clusterStill();
	void straighten();
	void joinBetween(const SharpFeatures& creases);
	bool mayJoinOn() const;
	void joinToSoFew();

	/// Whether there is time left to try what may not hold; else that is just divided.
	bool mayTry() const;
	bool isPromising() const { return !isPromising_ || isPromising_(planned_.surface); }
	void sewJoined();
	bool joinWithRoom(double room);
	void joinHeldWithDarts();
	void absorbSmallPanels();
	void absorbEach(int tries);
	bool absorb(int panel, int neighbour);
	bool keepIfAllHold(CutSurface changed);
	bool sewUntilAllHold(int rounds);
	std::vector<char> divideFailing(PlannedSurface& before, const SewnPanels& sewn);
	bool divideClusters(PlannedSurface& before, const std::vector<int>& panels);
	SewnPanels joinedWithDarts();
	bool divideByNormals(int panel);
	SewnPanels divideOverlapsOf(const SewnPanels& sewn);
	SewnPanels divideUntilAllHold();

	SewnPanels sewTogether(bool brief);
	SewnPanels confirmed(SewnPanels sewn);
	ClosingSteps closingSteps();
	SewnExcess sewnExcess();
	SewnPanels smoothSeams(SeamDrawing::Manner smoothest = SeamDrawing::Manner::Smooth);
	SewnPanels relieved(SewnPanels sewn, bool darts);
	SewnPanels withDarts(SewnPanels sewn);

	const CutOptions options_;
	const GivenPatches given_;
	PlannedSurface planned_;
	SewnPanels sewn_; // what becomes of it
	std::optional<PlannedSurface> joinedGreedily_, lessSmooth_;
	/// Panels that held, with the seams that were drawn and before.
	struct Held {
		PlannedSurface drawn, undrawn;
		std::vector<Eigen::Vector3d> dartTips;
	};
	std::optional<Held> held_;            // last
	std::vector<PlannedSurface> earlier_; // what stages before the last came to, the last of these first
	std::unique_ptr<PanelTests> tests_;
	std::unique_ptr<PanelSewing> sewing_;
	std::vector<int> clusters_; // per triangle, before any were joined
	/// Sewing all panels together takes long: so much work at most in each stage to see whether darts help,
	/// or closing overlaps.
	static constexpr double workOnReliefs = 1e7, workOnClosings = 1.2e7;
	double reliefsLeft_ = workOnReliefs, closingsLeft_ = workOnClosings;
	bool confirms_;                        ///< by whole runs
	double room_ = 1;                      ///< that panels have when they are joined, beside the most
	double workOnJoining_ = 0;             ///< before any were sewn together
	std::optional<SharpFeatures> creases_; // of what is developable between them
	const MirrorPlane* mirror_ = nullptr;
	std::function<bool(const CutSurface&)> isPromising_;
	std::vector<Eigen::Vector3d> dartTips_;
	JoinHistory history_;
};

} // namespace developable::detail
