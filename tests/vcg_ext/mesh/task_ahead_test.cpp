// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/task_ahead.h"

#include "developable/mesh/parallel_tasks.h"

#include <atomic>
#include <gtest/gtest.h>
#include <new>

namespace developable::test {
namespace {

TEST(TaskAhead, DoesNothingBeforeItBegins) {
	bool ran = false;
	{
		const TaskAhead task([&](const Progress&) { ran = true; });
		EXPECT_FALSE(task.begun());
	}
	EXPECT_FALSE(ran);
}

TEST(TaskAhead, RunsOnAThreadOfItsOwnWithoutMore) {
	std::thread::id where;
	int threads = 0;
	TaskAhead task([&](const Progress&) {
		where = std::this_thread::get_id();
		threads = threadsAtHand();
	});
	task.begin();
	EXPECT_TRUE(task.begun());
	task.finish({});
	EXPECT_NE(where, std::thread::id());
	EXPECT_NE(where, std::this_thread::get_id());
	EXPECT_EQ(threads, 1);
}

TEST(TaskAhead, HasEndedOnceItHasRun) {
	std::atomic<bool> wait = true;
	TaskAhead task([&](const Progress&) {
		while (wait)
			std::this_thread::yield();
	});
	EXPECT_FALSE(task.ended());
	task.begin();
	EXPECT_FALSE(task.ended());
	wait = false;
	task.finish({});
	EXPECT_TRUE(task.ended());
}

TEST(TaskAhead, StopsWhenItIsAbandoned) {
	std::atomic<bool> stopped = false;
	{
		TaskAhead task([&](const Progress& progress) {
			while (progress(0.5, "at work"))
				std::this_thread::yield();
			stopped = true;
		});
		task.begin();
	}
	EXPECT_TRUE(stopped);
}

TEST(TaskAhead, TellsHowFarItIsAndHandsAStopOn) {
	TaskAhead task([&](const Progress& progress) {
		while (progress(0.25, "at work"))
			std::this_thread::yield();
	});
	task.begin();
	const std::thread::id here = std::this_thread::get_id();
	task.finish([&](double fraction, const std::string& message) {
		EXPECT_EQ(fraction, 0.25);
		EXPECT_EQ(message, "at work");
		EXPECT_EQ(std::this_thread::get_id(), here);
		return false;
	});
}

TEST(TaskAhead, HandsOnWhatIsThrownToThoseWhoWaitForIt) {
	const auto fail = [](const Progress&) { throw std::bad_alloc(); };
	TaskAhead task(fail);
	task.begin();
	EXPECT_THROW(task.finish({}), std::bad_alloc);
	TaskAhead abandoned(fail);
	abandoned.begin(); // nobody learns of it
}

} // namespace
} // namespace developable::test
