// SPDX-License-Identifier: GPL-3.0-or-later
// parallel_tasks.h: independent tasks on several threads, with one progress for all of them.
#pragma once

#include "progress.h"

#include <vector>

namespace developable {

/// A piece of work that has no bearing on any other. When its progress asks for a stop it should end soon.
struct Task {
	double work = 1; ///< how much it is beside the others
	std::function<void(const Progress&)> run;
};

/// How many threads may work at once: as many as there are processors that this process may use, or fewer
/// when the environment variable OMP_NUM_THREADS says so, as it does in each worker of a batch.
int availableThreads();

/// How many threads this thread may work on itself: within a task its share of those there are, elsewhere all
/// that are available.
int threadsAtHand();

/// As long as it lives this thread may work on so many threads itself.
class ThreadShare {
public:
	explicit ThreadShare(int threads);
	ThreadShare(const ThreadShare&) = delete;
	ThreadShare& operator=(const ThreadShare&) = delete;
	~ThreadShare();

private:
	const int before_;
};

/// Runs all tasks, large ones first, and returns when they have ended. Progress is only called from the
/// calling thread.
///
/// \param threads  at most so many at once; 0: as many as are at hand
/// \throws what the first task that failed has thrown, after all have ended
void runTasks(const std::vector<Task>& tasks, int threads, const Progress& progress);

} // namespace developable
