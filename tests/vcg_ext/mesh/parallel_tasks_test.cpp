// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/mesh.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <set>
#include <thread>

namespace developable {
namespace {

using namespace std::chrono_literals;

/// A hundred tasks, each of which counts that it has run.
std::vector<Task> countingTasks(std::vector<int>& runs) {
	runs.assign(100, 0);
	std::vector<Task> tasks;
	tasks.reserve(100);
	for (int i = 0; i < 100; ++i)
		tasks.push_back({1.0 + i % 7, [&runs, i](const Progress& progress) {
							 ++runs[i];
							 mayGoOn(progress, 0.5, "half");
						 }});
	return tasks;
}

TEST(ParallelTasks, RunEachOnce) {
	std::vector<int> runs;
	for (const int threads : {0, 1, 2, 5, 1000}) {
		runTasks(countingTasks(runs), threads, {});
		EXPECT_EQ(runs, std::vector<int>(100, 1));
	}
	runTasks({}, 2, {});
}

TEST(ParallelTasks, UseNoMoreThreadsThanTheEnvironmentAllows) {
	const int processors = availableThreads();
	for (const auto& [asked, expected] : {std::pair("1", 1), std::pair("100000", processors),
										  std::pair("0", processors), std::pair("many", processors)}) {
		setenv("OMP_NUM_THREADS", asked, 1);
		EXPECT_EQ(availableThreads(), expected);
	}
	unsetenv("OMP_NUM_THREADS");
}

TEST(ParallelTasks, BeginWithTheLargest) {
	std::vector<int> order;
	std::vector<Task> tasks;
	for (const int size : {3, 1, 4, 1, 5})
		tasks.push_back({double(size), [&order, size](const Progress&) { order.push_back(size); }});
	runTasks(tasks, 1, {});
	EXPECT_EQ(order, (std::vector<int>{5, 4, 3, 1, 1}));
}

TEST(ParallelTasks, TellTheCallingThreadOfAllTheWork) {
	for (const int threads : {1, 3}) {
		std::vector<double> told;
		const auto caller = std::this_thread::get_id();
		std::vector<Task> tasks;
		tasks.reserve(4);
		for (int i = 0; i < 4; ++i)
			tasks.push_back({1, [](const Progress& progress) {
								 for (int step = 1; step <= 4; ++step) {
									 progress(step / 4.0, "step");
									 std::this_thread::sleep_for(15ms);
								 }
							 }});
		runTasks(tasks, threads, [&](double fraction, const std::string& message) {
			EXPECT_EQ(std::this_thread::get_id(), caller);
			EXPECT_EQ(message, "step");
			told.push_back(fraction);
			return true;
		});
		ASSERT_GE(told.size(), 2);
		EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
		EXPECT_GT(told.back(), 0.5);
		EXPECT_LE(told.back(), 1);
	}
}

TEST(ParallelTasks, StopWhenAsked) {
	for (const int threads : {1, 3}) {
		std::atomic<int> stopped = 0;
		std::vector<Task> tasks;
		tasks.reserve(6);
		for (int i = 0; i < 6; ++i)
			tasks.push_back({1, [&stopped](const Progress& progress) {
								 while (progress(0.1, "waiting"))
									 std::this_thread::sleep_for(1ms);
								 ++stopped;
							 }});
		int calls = 0;
		runTasks(tasks, threads, [&](double, const std::string&) { return ++calls < 3; });
		EXPECT_EQ(stopped, 6);
		EXPECT_EQ(calls, 3); // and is not asked again
	}
}

TEST(ParallelTasks, PassOnWhatTheFirstOfThemThrows) {
	for (const int threads : {1, 3}) {
		std::atomic<int> runs = 0;
		std::vector<Task> tasks;
		tasks.reserve(20);
		for (int i = 0; i < 20; ++i)
			tasks.push_back({1, [&runs, i](const Progress&) {
								 ++runs;
								 if (i == 7 || i == 12)
									 throw InvalidParameter(std::to_string(i));
							 }});
		try {
			runTasks(tasks, threads, {});
			FAIL();
		} catch (const InvalidParameter& error) {
			EXPECT_STREQ(error.what(), "7");
		}
		EXPECT_EQ(runs, 20);
	}
}

} // namespace
} // namespace developable
