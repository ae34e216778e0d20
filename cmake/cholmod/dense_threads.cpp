// SPDX-License-Identifier: GPL-3.0-or-later
// dense_threads.cpp: workers that wait for the next routine.
#include "dense_threads.h"

#include <condition_variable>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

class DenseThreads::Pool {
public:
	explicit Pool(int workers) {
		try {
			while (static_cast<int>(workers_.size()) < workers)
				workers_.emplace_back([this] { serve(); });
		} catch (const std::system_error&) {
			// Fewer threads do as well.
		} catch (const std::bad_alloc&) {
		}
	}

	~Pool() {
		{
			const std::lock_guard lock(mutex_);
			over_ = true;
		}
		changed_.notify_all();
		for (std::thread& worker : workers_)
			worker.join();
	}

	void run(int count, const std::function<void(int)>& work) {
		std::unique_lock lock(mutex_);
		work_ = &work;
		count_ = count;
		next_ = 0;
		outOfMemory_ = false;
		changed_.notify_all();
		takeAll(lock);
		idle_.wait(lock, [this] { return working_ == 0; });
		if (outOfMemory_)
			throw std::bad_alloc();
	}

private:
	void serve() {
		for (std::unique_lock lock(mutex_);;) {
			changed_.wait(lock, [this] { return over_ || next_ < count_; });
			if (over_)
				return;
			takeAll(lock);
			if (working_ == 0)
				idle_.notify_one();
		}
	}

	/// One piece after the other, as long as there are any.
	void takeAll(std::unique_lock<std::mutex>& lock) {
		++working_;
		while (next_ < count_) {
			const int piece = next_++;
			lock.unlock();
			bool failed = false;
			try {
				(*work_)(piece);
			} catch (const std::bad_alloc&) {
				failed = true;
			}
			lock.lock();
			outOfMemory_ = outOfMemory_ || failed;
		}
		--working_;
	}

	std::vector<std::thread> workers_;
	std::mutex mutex_;
	std::condition_variable changed_, idle_;
	const std::function<void(int)>* work_ = nullptr;
	int count_ = 0, next_ = 0, working_ = 0;
	bool outOfMemory_ = false, over_ = false;
};

DenseThreads*& DenseThreads::current() {
	static thread_local DenseThreads* threads = nullptr;
	return threads;
}

DenseThreads::DenseThreads(int threads) : threads_(threads), outer_(current()) {
	current() = this;
}

DenseThreads::~DenseThreads() {
	current() = outer_;
}

void DenseThreads::run(int count, const std::function<void(int)>& work) {
	DenseThreads* const threads = current();
	if (threads == nullptr || threads->threads_ < 2 || count < 2) {
		for (int piece = 0; piece < count; ++piece)
			work(piece);
		return;
	}
	if (!threads->pool_)
		threads->pool_ = std::make_unique<Pool>(threads->threads_ - 1);
	threads->pool_->run(count, work);
}
