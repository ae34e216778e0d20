// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts are found once, whoever asks, and tests ahead change nothing but the time that takes.
#include "developable/panels/panel_tests.h"

#include "panel_shapes.h"

#include <gtest/gtest.h>
#include <thread>

namespace developable::test {
namespace {

using detail::CutSurface;
using detail::PanelTester;
using detail::PanelTests;
using detail::PanelTrial;
using detail::PanelVerdict;
using detail::PanelVerdicts;

PanelVerdict developable() {
	PanelVerdict verdict;
	verdict.flat = verdict.disk = true;
	return verdict;
}

/// The halves of a cap, and the whole.
std::vector<PanelTrial> trialsOfCap() {
	const TriangleMesh mesh = grid(13, 13, sphereCap(1));
	const CutSurface halves = withPanels(mesh, strips(mesh, 2)), whole = withPanels(mesh, strips(mesh, 1));
	return {trialOf(halves, halves.trianglesOf(0)), trialOf(halves, halves.trianglesOf(1)),
			trialOf(whole, whole.trianglesOf(0))};
}

TEST(PanelVerdicts, areFoundOnce) {
	const TriangleMesh mesh = grid(3, 3, flatSheet);
	PanelVerdicts verdicts;
	EXPECT_FALSE(verdicts.has(mesh));
	EXPECT_TRUE(verdicts.want(mesh));
	EXPECT_FALSE(verdicts.want(mesh));
	EXPECT_FALSE(verdicts.has(mesh));
	std::atomic<int> found = 0, flat = 0;
	std::vector<std::thread> threads;
	for (int i = 0; i < 4; ++i)
		threads.emplace_back([&] {
			const auto verdict = verdicts.on(mesh, {}, [&] {
				++found;
				std::this_thread::sleep_for(std::chrono::milliseconds(30));
				return developable();
			});
			flat += verdict && verdict->flat;
		});
	for (std::thread& thread : threads)
		thread.join();
	EXPECT_EQ(found, 1);
	EXPECT_EQ(flat, 4);
	EXPECT_TRUE(verdicts.has(mesh));
	verdicts.forget();
	EXPECT_FALSE(verdicts.has(mesh));
}

TEST(PanelVerdicts, areLeftToOthersByWhoStopsOrFails) {
	const TriangleMesh mesh = grid(3, 3, flatSheet);
	PanelVerdicts verdicts;
	EXPECT_FALSE(verdicts.on(mesh, {}, [] { return std::nullopt; }));
	EXPECT_FALSE(verdicts.has(mesh));
	EXPECT_THROW(verdicts.on(mesh, {}, []() -> PanelVerdict { throw std::bad_alloc(); }), std::bad_alloc);
	EXPECT_FALSE(verdicts.has(mesh));
	EXPECT_TRUE(verdicts.on(mesh, {}, developable)->flat);
	EXPECT_TRUE(verdicts.on(mesh, {}, []() -> PanelVerdict { throw std::bad_alloc(); })->flat);
}

TEST(PanelTests, aheadGiveTheSameAndCountWhenTheyAreAskedFor) {
	const std::vector<PanelTrial> trials = trialsOfCap();
	PanelTests plain({0.05}, {}, {}), tests({0.05}, {}, {});
	const std::vector<PanelVerdict> expected = plain.test(trials);
	std::vector<PanelVerdict> found;
	const auto task = tests.testAhead([&](PanelTester& tester) { found = tester.test(trials); });
	ASSERT_TRUE(task->begun());
	task->finish({});
	EXPECT_EQ(tests.work(), 0);
	for (const PanelTrial& trial : trials)
		EXPECT_TRUE(tests.knowsSoon(trial));
	const std::vector<PanelVerdict> asked = tests.test(trials);
	EXPECT_EQ(tests.work(), plain.work());
	for (std::size_t i = 0; i < trials.size(); ++i) {
		EXPECT_EQ(found[i].flat, expected[i].flat);
		EXPECT_EQ(asked[i].meanDisplacement, expected[i].meanDisplacement);
		EXPECT_EQ(asked[i].worstPoint, expected[i].worstPoint);
	}
}

/// An unpromising trial is no verdict on the panel; any other is.
TEST(PanelTests, ofPromisingTrialsTellWhatTheyHaveFound) {
	const TriangleMesh mesh = grid(25, 25, sphereCap(1));
	const CutSurface surface = withPanels(mesh, strips(mesh, 1));
	const PanelTrial thorough = trialOf(surface, surface.trianglesOf(0));
	PanelTrial quick = thorough;
	quick.onlyIfPromising = true;
	for (const double limit : {1e-3, 0.5}) {
		PanelTests tests({limit}, {}, {});
		const PanelVerdict verdict = tests.test({quick}).front();
		EXPECT_EQ(verdict.obstacle == detail::Obstacle::Unpromising, limit < 0.1);
		EXPECT_TRUE(tests.knowsSoon(quick));
		EXPECT_EQ(tests.knowsSoon(thorough), limit > 0.1);
		EXPECT_EQ(tests.test({thorough}).front().isPanel(), limit > 0.1);
	}
}

TEST(PanelTests, knowWhichThreadsIdle) {
	const std::vector<PanelTrial> trials = trialsOfCap();
	PanelTests tests({0.05}, {}, {});
	const ThreadShare share(4);
	EXPECT_EQ(tests.idleBeside(trials), 1);
	tests.test({trials[0]});
	EXPECT_EQ(tests.idleBeside(trials), 2); // one verdict is known
	std::atomic<bool> wait = true;
	const auto task = tests.testAhead([&](PanelTester&) {
		while (wait)
			std::this_thread::yield();
	});
	EXPECT_EQ(tests.idleBeside(trials), 1);
	wait = false;
	task->finish({});
	EXPECT_EQ(tests.idleBeside(trials), 2);
}

TEST(PanelTests, aheadStopWhenTheyAreAbandonedAndMeanNothingThen) {
	const std::vector<PanelTrial> trials = trialsOfCap();
	PanelTests tests({0.05}, {}, {});
	std::atomic<bool> began = false, stopped = false;
	{
		detail::TestsAhead ahead(tests);
		ahead.begin([&](PanelTester& tester) {
			for (int i = 0; !tester.stopped(); ++i) {
				std::vector<PanelTrial> moved = {trials[2]};
				moved[0].panel.positions.row(0).array() += i; // another panel each time
				tester.test(moved);
				began = true;
			}
			stopped = true;
		});
		while (!began)
			std::this_thread::yield();
	}
	EXPECT_TRUE(stopped);
	EXPECT_FALSE(tests.stopped());
}

} // namespace
} // namespace developable::test
