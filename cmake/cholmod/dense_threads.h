// SPDX-License-Identifier: GPL-3.0-or-later
// dense_threads.h: the threads on which large dense routines work.
#pragma once

#include <functional>
#include <memory>

/// While it lives, large dense routines called from the thread that made it work on several threads. These
/// begin with the first such routine; what they make has the same bits for any number of threads.
class DenseThreads {
public:
	/// \param threads  at most so many at once, the caller's among them
	explicit DenseThreads(int threads);
	~DenseThreads();
	DenseThreads(const DenseThreads&) = delete;
	DenseThreads& operator=(const DenseThreads&) = delete;

	/// Does work(0) to work(count − 1), each once, in any order, on the threads that the caller has.
	/// \throws std::bad_alloc  after all have ended, when one of them has
	static void run(int count, const std::function<void(int)>& work);

private:
	class Pool;

	/// The one that lives in this thread, or null.
	static DenseThreads*& current();

	int threads_;
	DenseThreads* outer_;
	std::unique_ptr<Pool> pool_;
};
