// SPDX-License-Identifier: GPL-3.0-or-later
// parallel_tasks.cpp: workers that take one task after the other, and the caller who tells how far they are.
#include "parallel_tasks.h"

#include "pace_of_looks.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <new>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>
#ifdef __linux__
#include <sched.h>
#endif

namespace developable {

namespace {

/// Of the task that this thread works on; 0: none.
int& shareOfThisThread() {
	static thread_local int share = 0;
	return share;
}

class TaskRun {
public:
	/// \param share  threads that a task may work on itself
	TaskRun(const std::vector<Task>& tasks, int share, const Progress& progress)
		: tasks_(tasks), share_(share), progress_(progress), order_(tasks.size()),
		  fractions_(tasks.size(), 0), errors_(tasks.size()) {
		std::iota(order_.begin(), order_.end(), 0);
		std::stable_sort(order_.begin(), order_.end(),
						 [&](int a, int b) { return tasks[a].work > tasks[b].work; });
		for (const Task& task : tasks)
			wholeWork_ += task.work;
	}

	void inThisThread() {
		work([this] { return tell(); });
		rethrow();
	}

	void onThreads(int count) {
		std::vector<std::thread> workers;
		workers.reserve(count);
		try {
			while (static_cast<int>(workers.size()) < count)
				workers.emplace_back([this] {
					work([this] { return !stop_; });
					const std::lock_guard lock(mutex_);
					++ended_;
					someEnded_.notify_one();
				});
		} catch (const std::system_error&) {
			// Fewer threads do as well.
		} catch (const std::bad_alloc&) {
		}
		if (workers.empty())
			return inThisThread();
		watch(static_cast<int>(workers.size()));
		for (std::thread& worker : workers)
			worker.join();
		rethrow();
	}

private:
	/// \param goOn  asked whenever a task says how far it is
	template <class GoOn>
	void work(const GoOn& goOn) {
		const ThreadShare share(share_);
		for (std::size_t i = next_++; i < order_.size(); i = next_++) {
			const int task = order_[i];
			try {
				const Progress progress = [&, task](double fraction, const std::string& message) {
					note(task, fraction, message);
					return goOn();
				};
				tasks_[task].run(progress_ ? progress : Progress());
			} catch (...) {
				errors_[task] = std::current_exception();
			}
			note(task, 1, "");
		}
	}

	void note(int task, double fraction, const std::string& message) {
		const std::lock_guard lock(mutex_);
		fractions_[task] = fraction;
		if (!message.empty())
			message_ = message;
	}

	/// \return false once a stop was asked for
	bool tell() {
		double done = 0;
		std::string message;
		{
			const std::lock_guard lock(mutex_);
			for (std::size_t i = 0; i < tasks_.size(); ++i)
				done += tasks_[i].work * fractions_[i];
			message = message_;
		}
		if (!stop_ && !message.empty() && !mayGoOn(progress_, done / wholeWork_, message))
			stop_ = true;
		return !stop_;
	}

	/// Until all workers have ended. Should telling fail, they are stopped first.
	void watch(int workers) {
		for (std::unique_lock lock(mutex_); ended_ < workers;) {
			someEnded_.wait_for(lock, betweenLooks, [&] { return ended_ == workers; });
			lock.unlock();
			try {
				if (!failure_)
					tell();
			} catch (...) {
				failure_ = std::current_exception();
				stop_ = true;
			}
			lock.lock();
		}
	}

	void rethrow() const {
		if (failure_)
			std::rethrow_exception(failure_);
		for (const std::exception_ptr& error : errors_)
			if (error)
				std::rethrow_exception(error);
	}

	const std::vector<Task>& tasks_;
	const int share_;
	const Progress& progress_;
	std::vector<int> order_;
	std::atomic<std::size_t> next_ = 0;
	std::atomic<bool> stop_ = false;
	std::mutex mutex_;
	std::condition_variable someEnded_;
	int ended_ = 0; ///< workers
	double wholeWork_ = 0;
	std::vector<double> fractions_;
	std::string message_;
	std::vector<std::exception_ptr> errors_; ///< of the tasks
	std::exception_ptr failure_;             ///< of telling how far they are
};

int availableProcessors() {
#ifdef __linux__
	cpu_set_t processors;
	if (sched_getaffinity(0, sizeof processors, &processors) == 0)
		return std::max(1, CPU_COUNT(&processors));
#endif
	return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace

int availableThreads() {
	const char* asked = std::getenv("OMP_NUM_THREADS");
	const int most = asked == nullptr ? 0 : std::atoi(asked);
	const int processors = availableProcessors();
	return most > 0 ? std::min(most, processors) : processors;
}

ThreadShare::ThreadShare(int threads) : before_(std::exchange(shareOfThisThread(), threads)) {}

ThreadShare::~ThreadShare() {
	shareOfThisThread() = before_;
}

int threadsAtHand() {
	return shareOfThisThread() > 0 ? shareOfThisThread() : availableThreads();
}

void runTasks(const std::vector<Task>& tasks, int threads, const Progress& progress) {
	const int count = std::min<int>(threads > 0 ? threads : threadsAtHand(), static_cast<int>(tasks.size()));
	TaskRun run(tasks, std::max(1, threadsAtHand() / std::max(1, count)), progress);
	if (count > 1)
		run.onThreads(count);
	else
		run.inThisThread();
}

} // namespace developable
