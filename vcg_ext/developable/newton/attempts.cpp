// SPDX-License-Identifier: GPL-3.0-or-later
// attempts.cpp: one attempt after the other, or two at once.
#include "attempts.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

namespace {

/// What an attempt says, as its part of all: the first most often is the only one.
Progress progressOfAttempt(const Progress& progress, int attempt) {
	constexpr double left = 0.5; // of what is left, to the attempts behind
	const double begin = 1 - std::pow(left, attempt), end = 1 - std::pow(left, attempt + 1);
	return partOf(progress, begin, end);
}

/// An attempt that may be needed next, on another thread. It has a problem of its own, and what work and
/// steps there were when the one before it began.
class AttemptAhead {
public:
	AttemptAhead(const NewtonProblem& problem, const Positions& start, AttemptSetting setting)
		: budget_(std::make_shared<WorkBudget>(problem.budget().left())), setting_(std::move(setting)),
		  task_([this, &problem, &start](const Progress& progress) {
			  const std::unique_ptr<NewtonProblem> own = problem.another();
			  own->setBudget(budget_);
			  result_ = attempt(*own, start, setting_, progress);
		  }) {}

	void begin() { task_.begin(); }
	bool begun() const { return task_.begun(); }

	/// Waits for its end. \return whether it would have gone the same way by itself, one after the other
	/// \param setting  what it was to do
	/// \param budget   what work there is by now; becomes less by what this took
	bool finish(const AttemptSetting& setting, WorkBudget& budget, const Progress& progress) {
		task_.finish(progress);
		const bool same = result_.ending == Ending::Stopped ||
						  (setting_.smoothness == setting.smoothness &&
						   result_.iterations < setting.maxIterations && budget_->used() < budget.left());
		if (same)
			budget.spend(budget_->used());
		return same;
	}
	const AttemptResult& result() const { return result_; }

private:
	const std::shared_ptr<WorkBudget> budget_;
	const AttemptSetting setting_;
	AttemptResult result_;
	TaskAhead task_; // the last: it ends before what it works on
};

/// All attempts on one level.
class Attempts {
public:
	Attempts(NewtonProblem& problem, const Positions& start, double smoothness, int maxIterations,
			 const Progress& progress)
		: problem_(problem), start_(start), maxIterations_(maxIterations), progress_(progress),
		  smoothness_(Eigen::VectorXd::Constant(problem.assembly().patchCount(), smoothness)),
		  startDefects_(flatDefects(problem.assembly(), start)), leastDefects_(startDefects_) {
		best_.positions = best_.unlimited = start;
		best_.smoothness = smoothness;
	}

	NewtonOutcome run() {
		if (withLimits())
			return best_;
		if (!metLimits_) // without limits it would go the same way again
			ahead_.reset();
		for (int i = metLimits_ ? 0 : 1; i < problem_.tuning().attempts; ++i)
			if (withoutLimits(i))
				break;
		return best_;
	}

private:
	/// The nearest developable shape whose borders don't kink, if that is soon found.
	/// \return whether that was the last attempt
	bool withLimits();
	/// \return whether that was the last attempt
	bool withoutLimits(int i);

	int stepsLeft() const { return maxIterations_ - best_.iterations; }
	AttemptSetting settingOf(int i) const { return {smoothness_, false, i > 0, stepsLeft()}; }
	/// Whether what the attempt after this one is to do is known before.
	bool knowsNext(int i) const { return i < 1 || problem_.assembly().patchCount() == 1; }
	AttemptSetting nextSetting(int i) const;

	/// Counts work and steps.
	/// \param i  -1: the one that limits borders
	AttemptResult take(const AttemptSetting& setting, int i);
	void note(const AttemptResult& result);
	void keepIfBest(const AttemptResult& result);

	NewtonProblem& problem_;
	const Positions& start_;
	const int maxIterations_;
	const Progress& progress_;
	Eigen::VectorXd smoothness_; // of the attempt at hand
	const Eigen::VectorXd startDefects_;
	Eigen::VectorXd leastDefects_;
	NewtonOutcome best_;
	bool metLimits_ = true;
	std::unique_ptr<AttemptAhead> ahead_;
};

AttemptSetting Attempts::nextSetting(int i) const {
	AttemptSetting next = settingOf(i + 1);
	if (i > 0)
		next.smoothness *= problem_.tuning().smoothnessIncrease;
	return next;
}

AttemptResult Attempts::take(const AttemptSetting& setting, int i) {
	const Progress progress = progressOfAttempt(progress_, i + 1);
	if (const std::unique_ptr<AttemptAhead> done = std::move(ahead_); done && done->begun())
		if (done->finish(setting, problem_.budget(), progress))
			return done->result();
	const NewtonTuning& tuning = problem_.tuning();
	if (threadsAtHand() > 1 && knowsNext(i) && i + 1 < tuning.attempts)
		ahead_ = std::make_unique<AttemptAhead>(problem_, start_, nextSetting(i));
	const double patience =
		problem_.budget().used() + tuning.workBeforeNext * problem_.assembly().placeCount();
	return attempt(problem_, start_, setting, [&](double fraction, const std::string& message) {
		if (ahead_ && !ahead_->begun() && problem_.budget().used() > patience)
			ahead_->begin();
		return mayGoOn(progress, fraction, message);
	});
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
	best_.smoothness = smoothness_.maxCoeff();
}

bool Attempts::withLimits() {
	const int steps = std::min(maxIterations_, problem_.tuning().limitedSteps);
	if (steps < maxIterations_ && steps == 0)
		return false;
	AttemptResult result = take({smoothness_, true, false, steps}, -1);
	if (result.ending == Ending::OutOfSteps && steps < maxIterations_)
		result.ending = Ending::Stuck;
	note(result);
	if (best_.ending == Ending::Stopped)
		return true;
	keepIfBest(result);
	metLimits_ = result.metLimits;
	best_.bordersLimited = result.ending == Ending::Reached && result.bordersLimited;
	return result.ending != Ending::Stuck;
}

bool Attempts::withoutLimits(int i) {
	const NewtonTuning& tuning = problem_.tuning();
	const AttemptResult result = take(settingOf(i), i);
	note(result);
	// The attempts before had ended by themselves, and stiffer triangles are what can't be solved for.
	const bool gaveUp = result.ending == Ending::OutOfSteps || result.ending == Ending::Unsolvable;
	if (gaveUp && (i > 0 || problem_.budget().spent()))
		best_.ending = Ending::Stuck;
	if (best_.ending == Ending::Stopped)
		return true;
	keepIfBest(result);
	if (i == 0)
		best_.unlimited = result.positions;
	const bool smootherLeadsFarther = best_.nearestDevelopable > 0 && i > 0;
	if (best_.ending != Ending::Stuck || smootherLeadsFarther || problem_.budget().spent() || result.hopeless)
		return true;
	if (i > 0) {
		const Eigen::VectorXd defects = flatDefects(problem_.assembly(), result.positions);
		smoothness_ = problem_.goal()
						  .unmetPatches(problem_.assembly(), defects)
						  .select(tuning.smoothnessIncrease * smoothness_, smoothness_);
	}
	return false;
}

} // namespace

NewtonOutcome attemptFrom(NewtonProblem& problem, const Positions& start, double smoothness,
						  int maxIterations, const Progress& progress) {
	return Attempts(problem, start, smoothness, maxIterations, progress).run();
}

} // namespace developable::detail
