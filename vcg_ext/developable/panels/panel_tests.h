// SPDX-License-Identifier: GPL-3.0-or-later
// panel_tests.h: tests of panels of a cut surface, as they are or as they would be, several at once.
#pragma once

#include "cut_surface.h"
#include "panel_verdicts.h"

#include "developable/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

namespace developable::detail {

/// A panel that might be.
struct PanelTrial {
	TriangleMesh panel;
	int patch = 0;
	bool onlyIfPromising = false; ///< else it is not tested, see testIfPromising
};

/// \param triangles  ascending, of one patch
PanelTrial trialOf(const CutSurface& surface, const std::vector<int>& triangles);

/// What meets at some half edges, without the cuts there. The surface is the same afterwards.
PanelTrial trialAcross(CutSurface& surface, const std::vector<int>& halfEdges);

/// Who can be asked for verdicts.
class PanelTester {
public:
	virtual ~PanelTester() = default;

	virtual std::vector<PanelVerdict> test(const std::vector<PanelTrial>& trials) = 0;
	/// Then verdicts mean nothing.
	virtual bool stopped() const = 0;
};

class PanelTests : public PanelTester {
public:
	/// \param maxDisplacement  per patch of the surface, length
	PanelTests(std::vector<double> maxDisplacement, const PanelMaterial& material, Progress progress);

	/// Within what a patch's panels have to stay, by themselves: sewn together they will move a little more.
	PanelLimits limitsOf(int patch) const;
	/// No panel may overlap itself at all. To be called before any is tested.
	void refuseNotches() { notch_ = 0; }
	/// All limits are so many times what they were at first.
	void scaleLimits(double factor);

	std::vector<PanelVerdict> test(const std::vector<PanelTrial>& trials) override;
	/// Whether all are panels; not when the user asks for a stop.
	bool areAllPanels(const std::vector<PanelTrial>& trials);

	/// How many threads will idle while some trials are tested.
	int idleBeside(const std::vector<PanelTrial>& trials) const;
	/// Begins on such a thread what will be asked for next if the trials of now fail: the verdicts are the
	/// same, and known sooner. They count as work when they are asked for.
	std::unique_ptr<TaskAhead> testAhead(std::function<void(PanelTester&)> job);
	/// Whether a verdict is known, or some thread is about to know it.
	bool knowsSoon(const PanelTrial& trial) const {
		return verdicts_[trial.onlyIfPromising].has(trial.panel);
	}

	/// Says how far the work is. \return false when the user asked for a stop, now or before
	bool mayGoOn(double fractionDone, const std::string& message);
	bool stopped() const override { return stopped_; }

	/// What tests took, in units of WorkBudget: what time may be measured by and be the same on every run.
	double work() const { return work_; }
	/// What it may come to, when a stage may do so much beside what was done before; a little it may always
	/// do, and never very much.
	double workWith(double share) const { return work_ + std::clamp(share * work_, smallWork, muchWork); }

private:
	static constexpr double smallWork = 2e6, muchWork = 1.5e7; // a second or two, and half a minute at most
	class Ahead;

	/// \return nothing where it was asked to stop
	std::optional<PanelVerdict> verdictOn(const PanelTrial& trial, const Progress& progress);
	std::optional<PanelVerdict> found(const PanelTrial& trial, const Progress& progress) const;
	void countWork(const PanelTrial& trial, const PanelVerdict& verdict);

	const std::vector<double> maxDisplacement_;
	const PanelMaterial material_;
	const Progress progress_;
	double scale_ = 1, notch_ = PanelLimits().notch;
	double work_ = 0;
	std::array<PanelVerdicts, 2> verdicts_; // of trials by whether they are tested only if promising
	std::atomic<int> jobsAhead_{0};         // that have not ended
	std::atomic<bool> stopped_{false};
	double fractionDone_ = 0;
	std::string message_;
};

/// Tests ahead that are of use as long as the surface is what it is.
class TestsAhead {
public:
	explicit TestsAhead(PanelTests& tests) : tests_(tests) {}

	void begin(std::function<void(PanelTester&)> job);
	void abandon() { jobs_.clear(); }

private:
	PanelTests& tests_;
	std::vector<std::unique_ptr<TaskAhead>> jobs_;
};

} // namespace developable::detail
