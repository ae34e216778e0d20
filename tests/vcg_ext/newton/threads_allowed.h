// SPDX-License-Identifier: GPL-3.0-or-later
// threads_allowed.h: how many threads the environment allows, for as long as a test needs it.
#pragma once

#include <cstdlib>

namespace developable::test {

class ThreadsAllowed {
public:
	explicit ThreadsAllowed(const char* count) { setenv("OMP_NUM_THREADS", count, 1); }
	ThreadsAllowed(const ThreadsAllowed&) = delete;
	ThreadsAllowed& operator=(const ThreadsAllowed&) = delete;
	~ThreadsAllowed() { unsetenv("OMP_NUM_THREADS"); }
};

} // namespace developable::test
