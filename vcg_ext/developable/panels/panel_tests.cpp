// SPDX-License-Identifier: GPL-3.0-or-later
// panel_tests.cpp: tests in parallel; a stop reaches them all.
#include "panel_tests.h"

namespace developable::detail {

namespace {

constexpr double shareAlone = 0.75;    ///< of the greatest displacement: what a panel may need by itself
constexpr double meanOfGreatest = 0.3; ///< mean displacement as a share of the greatest

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
	return {greatest, meanOfGreatest * greatest, material_, notch_};
}

void PanelTests::scaleLimits(double factor) {
	if (factor != scale_)
		for (PanelVerdicts& verdicts : verdicts_)
			verdicts.forget();
	scale_ = factor;
}

std::optional<PanelVerdict> PanelTests::found(const PanelTrial& trial, const Progress& progress) const {
	bool stopped = false;
	PanelVerdict verdict = (trial.onlyIfPromising ? testIfPromising : testPanel)(
		trial.panel, limitsOf(trial.patch), [&](double done, const std::string& message) {
			stopped = stopped || !developable::mayGoOn(progress, done, message);
			return !stopped;
		});
	if (stopped)
		return {};
	return verdict;
}

std::optional<PanelVerdict> PanelTests::verdictOn(const PanelTrial& trial, const Progress& progress) {
	std::optional<PanelVerdict> verdict =
		verdicts_[trial.onlyIfPromising].on(trial.panel, progress, [&] { return found(trial, progress); });
	if (trial.onlyIfPromising && verdict && verdict->obstacle != Obstacle::Unpromising)
		verdicts_[false].on(trial.panel, progress, [&] { return verdict; });
	return verdict;
}

/// What is asked for the first time.
void PanelTests::countWork(const PanelTrial& trial, const PanelVerdict& verdict) {
	bool isFirst = verdicts_[trial.onlyIfPromising].want(trial.panel);
	if (trial.onlyIfPromising && verdict.obstacle != Obstacle::Unpromising)
		isFirst = verdicts_[false].want(trial.panel) && isFirst;
	work_ += isFirst ? verdict.work : 0;
}

std::vector<PanelVerdict> PanelTests::test(const std::vector<PanelTrial>& trials) {
	std::vector<PanelVerdict> verdicts(trials.size());
	std::vector<Task> tasks;
	tasks.reserve(trials.size());
	for (std::size_t i = 0; i < trials.size(); ++i)
		tasks.push_back({1, [&, i](const Progress& progress) {
							 if (!stopped_)
								 verdicts[i] = verdictOn(trials[i], progress).value_or(PanelVerdict());
						 }});
	runTasks(tasks, 0, [&](double, const std::string&) { return mayGoOn(fractionDone_, message_); });
	for (std::size_t i = 0; i < trials.size(); ++i)
		countWork(trials[i], verdicts[i]);
	return verdicts;
}

int PanelTests::idleBeside(const std::vector<PanelTrial>& trials) const {
	const auto busy = std::count_if(trials.begin(), trials.end(),
									[&](const PanelTrial& trial) { return !knowsSoon(trial); });
	return threadsAtHand() - static_cast<int>(busy) - jobsAhead_;
}

/// Those of a job ahead, one after the other.
class PanelTests::Ahead : public PanelTester {
public:
	Ahead(PanelTests& tests, const Progress& progress) : tests_(tests), progress_(progress) {}
	Ahead(const Ahead&) = delete;
	Ahead& operator=(const Ahead&) = delete;
	~Ahead() override { --tests_.jobsAhead_; }

	std::vector<PanelVerdict> test(const std::vector<PanelTrial>& trials) override {
		std::vector<PanelVerdict> verdicts(trials.size());
		for (std::size_t i = 0; i < trials.size() && !stopped_; ++i) {
			const std::optional<PanelVerdict> verdict = tests_.verdictOn(trials[i], progress_);
			stopped_ = !verdict;
			verdicts[i] = verdict.value_or(PanelVerdict());
		}
		return verdicts;
	}
	bool stopped() const override { return stopped_; }

private:
	PanelTests& tests_;
	const Progress& progress_;
	bool stopped_ = false;
};

std::unique_ptr<TaskAhead> PanelTests::testAhead(std::function<void(PanelTester&)> job) {
	auto task = std::make_unique<TaskAhead>([this, job = std::move(job)](const Progress& progress) {
		Ahead ahead(*this, progress);
		job(ahead);
	});
	++jobsAhead_;
	task->begin();
	if (!task->begun())
		--jobsAhead_;
	return task;
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

void TestsAhead::begin(std::function<void(PanelTester&)> job) {
	jobs_.erase(std::remove_if(jobs_.begin(), jobs_.end(), [](const auto& task) { return task->ended(); }),
				jobs_.end());
	jobs_.push_back(tests_.testAhead(std::move(job)));
}

} // namespace developable::detail
