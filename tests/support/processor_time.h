// SPDX-License-Identifier: GPL-3.0-or-later
// processor_time.h: time as benchmarks measure it.
#pragma once

#include <algorithm>
#include <ctime>

namespace developable::test {

/// Seconds of this process alone, so that others on the machine disturb less.
inline double processorSeconds() {
	timespec time;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
	return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The best of some runs: the least disturbed.
template <class Run>
double leastSeconds(const Run& run, int runs) {
	double least = 1e300;
	for (int i = 0; i < runs; ++i) {
		const double start = processorSeconds();
		run();
		least = std::min(least, processorSeconds() - start);
	}
	return least;
}

} // namespace developable::test
