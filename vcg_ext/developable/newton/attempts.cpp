// SPDX-License-Identifier: GPL-3.0-or-later
// attempts.cpp: one attempt after the other, or both at once.
#include "attempts.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

namespace {

/// Of the progress: most often the careful attempt is the only one.
constexpr double shareOfCareful = 0.6;
/// Of what the careful attempt leaves to the free one, which may be less by its last step.
constexpr double shareOfReserve = 0.9;

/// An attempt that may be needed next, on another thread. It has a problem of its own, and what work and
/// steps there were when the one before it began.
class AttemptAhead {
public:
	/// \param work  that it may take, in units of WorkBudget
	AttemptAhead(const NewtonProblem& problem, const Positions& start, AttemptSetting setting, double work)
		: budget_(std::make_shared<WorkBudget>(work, problem.budget().extraLeft())), setting_(setting),
		  task_([this, &problem, &start](const Progress& progress) {
			  const std::unique_ptr<NewtonProblem> own = problem.another();
			  own->setBudget(budget_);
			  result_ = attempt(*own, start, setting_, progress);
		  }) {}

	void begin() { task_.begin(); }
	bool begun() const { return task_.begun(); }

	/// Waits for its end, if it does what is to be done. \return whether it would have gone the same way by
	/// itself, one after the other
	/// \param setting  what it is to do, as far as is known by now
	/// \param budget   what work there is by now; becomes less by what this took
	bool finish(const AttemptSetting& setting, WorkBudget& budget, const Progress& progress) {
		if (setting.stiffens != setting_.stiffens)
			return false;
		task_.finish(progress);
		const bool same = result_.ending == Ending::Stopped ||
						  (result_.iterations < setting.maxIterations && budget_->used() < budget.left() &&
						   budget_->extraUsed() < budget.extraLeft());
		if (same)
			budget.spend(*budget_);
		return same;
	}
	const AttemptResult& result() const { return result_; }

private:
	const std::shared_ptr<WorkBudget> budget_;
	const AttemptSetting setting_;
	AttemptResult result_;
	TaskAhead task_; // the last: it ends before what it works on
};

/// Both attempts on one level.
class Attempts {
public:
	Attempts(NewtonProblem& problem, const Positions& start, double smoothness, int maxIterations,
			 const Progress& progress)
		: problem_(problem), start_(start), smoothness_(smoothness), maxIterations_(maxIterations),
		  progress_(progress),
		  workWhenFree_(shareOfReserve * problem.tuning().reserveOfCareful * problem.budget().left()),
		  startDefects_(flatDefects(problem.assembly(), start)), leastDefects_(startDefects_) {
		best_.positions = best_.free = start;
	}

	NewtonOutcome run() {
		const NewtonTuning& tuning = problem_.tuning();
		const int together = problem_.assembly().isSewn() ? tuning.togetherSteps : 0;
		const int steps =
			tuning.limitedSteps > 0 ? std::min(maxIterations_, tuning.limitedSteps + together) : 0;
		const bool careful = steps > 0 || maxIterations_ == 0;
		if (!careful || !beCareful(steps))
			beFree(careful);
		return best_;
	}

private:
	/// \return whether that was all
	bool beCareful(int steps);
	/// \param again  after a careful attempt
	void beFree(bool again);

	AttemptSetting freeSetting() const {
		return {smoothness_, false, maxIterations_ - best_.iterations, stiffens_};
	}
	AttemptResult takeCareful(int steps);
	AttemptResult takeFree(bool again);
	/// Counts steps.
	void note(const AttemptResult& result);
	void keepIfBest(const AttemptResult& result);

	NewtonProblem& problem_;
	const Positions& start_;
	const double smoothness_;
	const int maxIterations_;
	const Progress& progress_;
	const double workWhenFree_; ///< after a careful attempt
	const Eigen::VectorXd startDefects_;
	Eigen::VectorXd leastDefects_;
	NewtonOutcome best_;
	bool stiffens_ = false; // the free one
	std::unique_ptr<AttemptAhead> ahead_;
};

AttemptResult Attempts::takeCareful(int steps) {
	const NewtonTuning& tuning = problem_.tuning();
	const Progress progress = partOf(progress_, 0, shareOfCareful);
	WorkReserve reserve(problem_.budget(), tuning.reserveOfCareful);
	const double patience =
		problem_.budget().usedForTheRest() + tuning.workBeforeNext * problem_.assembly().placeCount();
	return attempt(problem_, start_, {smoothness_, true, steps, false, &reserve},
				   [&](double fraction, const std::string& message) {
					   if (ahead_ && !ahead_->begun() && problem_.budget().usedForTheRest() > patience)
						   ahead_->begin();
					   return mayGoOn(progress, fraction, message);
				   });
}

AttemptResult Attempts::takeFree(bool again) {
	const Progress progress = partOf(progress_, shareOfCareful, 1);
	const AttemptSetting setting = freeSetting();
	if (!again)
		return attempt(problem_, start_, setting, progress);
	WorkBudget& budget = problem_.budget();
	if (ahead_ && ahead_->begun() && ahead_->finish(setting, budget, progress))
		return ahead_->result();
	ahead_.reset(); // and what it is still at
	const WorkReserve reserve(budget, 1 - std::min(1.0, workWhenFree_ / budget.left()));
	return attempt(problem_, start_, setting, progress);
}

void Attempts::note(const AttemptResult& result) {
	best_.ending = result.ending;
	best_.iterations += result.iterations;
	if (result.ending == Ending::Reached)
		best_.nearestDevelopable = 0;
	else if (result.nearestDevelopable > 0)
		best_.nearestDevelopable = best_.nearestDevelopable > 0
									   ? std::min(best_.nearestDevelopable, result.nearestDevelopable)
									   : result.nearestDevelopable;
}

void Attempts::keepIfBest(const AttemptResult& result) {
	const PatchAssembly& assembly = problem_.assembly();
	const Eigen::VectorXd defects = flatDefects(assembly, result.positions);
	const bool best =
		better(assembly, defects, startDefects_) && lessCurved(assembly, defects, leastDefects_);
	if (result.iterations == 0 || (result.ending != Ending::Reached && !best))
		return;
	leastDefects_ = defects;
	best_.positions = result.positions;
}

bool Attempts::beCareful(int steps) {
	if (threadsAtHand() > 1)
		ahead_ = std::make_unique<AttemptAhead>(problem_, start_, freeSetting(), workWhenFree_);
	AttemptResult result = takeCareful(steps);
	if (result.ending == Ending::OutOfSteps && steps < maxIterations_)
		result.ending = Ending::Stuck;
	note(result);
	if (best_.ending == Ending::Stopped)
		return true;
	keepIfBest(result);
	best_.bordersLimited = result.ending == Ending::Reached && result.bordersLimited;
	// Where much is left, thin triangles may have been in the way; where not, and borders came to no limit,
	// the free attempt would hardly go another way.
	stiffens_ = !result.cameNear;
	return result.ending != Ending::Stuck || (result.cameNear && !result.metLimits);
}

void Attempts::beFree(bool again) {
	const AttemptResult result = takeFree(again);
	note(result);
	// The attempt before had ended by itself, or the work was spent before the steps were.
	if ((again && result.ending == Ending::Unsolvable) ||
		(result.ending == Ending::OutOfSteps && best_.iterations < maxIterations_))
		best_.ending = Ending::Stuck;
	if (best_.ending == Ending::Stopped)
		return;
	keepIfBest(result);
	best_.free = result.positions;
}

} // namespace

NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress) {
	return Attempts(problem, start, smoothness, maxIterations, progress).run();
}

} // namespace developable::detail
