// SPDX-License-Identifier: GPL-3.0-or-later
// task_ahead.cpp: the thread, and what is told while one waits for it.
#include "task_ahead.h"

#include "pace_of_looks.h"
#include "parallel_tasks.h"

#include <new>
#include <system_error>

namespace developable {

TaskAhead::~TaskAhead() {
	{
		const std::lock_guard lock(mutex_);
		stop_ = true;
	}
	if (thread_.joinable())
		thread_.join();
}

void TaskAhead::begin() {
	try {
		thread_ = std::thread([this] { work(); });
	} catch (const std::system_error&) {
		// It is done later, where it is needed.
	} catch (const std::bad_alloc&) {
	}
}

bool TaskAhead::ended() const {
	const std::lock_guard lock(mutex_);
	return ended_;
}

void TaskAhead::work() {
	const ThreadShare alone(1);
	try {
		run_([this](double fraction, const std::string& message) {
			const std::lock_guard lock(mutex_);
			fraction_ = fraction;
			message_ = message;
			return !stop_;
		});
	} catch (...) {
		error_ = std::current_exception();
	}
	const std::lock_guard lock(mutex_);
	ended_ = true;
	end_.notify_one();
}

void TaskAhead::finish(const Progress& progress) {
	for (std::unique_lock lock(mutex_); !ended_;) {
		const double fraction = fraction_;
		const std::string message = message_;
		lock.unlock();
		const bool goOn = message.empty() || mayGoOn(progress, fraction, message);
		lock.lock();
		stop_ = stop_ || !goOn;
		end_.wait_for(lock, betweenLooks, [&] { return ended_; });
	}
	thread_.join();
	if (error_)
		std::rethrow_exception(error_);
}

} // namespace developable
