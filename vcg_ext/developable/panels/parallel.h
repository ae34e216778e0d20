// SPDX-License-Identifier: GPL-3.0-or-later
// parallel.h: independent pieces of work on all processors; what comes out does not depend on how many.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace developable::detail {

/// Calls work(i, ofCaller) for every i below count, on as many threads as there are processors. `ofCaller`
/// is true in the thread that called, the only one in which a host's functions may be called.
/// \throws what the work with the smallest number threw
inline void inParallel(int count, const std::function<void(int, bool)>& work) {
	std::atomic<int> next{0};
	std::vector<std::exception_ptr> failures(count);
	const auto run = [&](bool ofCaller) {
		for (int i = next++; i < count; i = next++)
			try {
				work(i, ofCaller);
			} catch (...) {
				failures[i] = std::current_exception();
			}
	};
	const int processors = static_cast<int>(std::thread::hardware_concurrency());
	std::vector<std::thread> others;
	for (int i = 1; i < std::min(processors, count); ++i)
		others.emplace_back(run, false);
	run(true);
	for (std::thread& other : others)
		other.join();
	for (const std::exception_ptr& failure : failures)
		if (failure)
			std::rethrow_exception(failure);
}

} // namespace developable::detail
