// SPDX-License-Identifier: GPL-3.0-or-later
// task_ahead.h: work that may turn out to be needed next, begun on a thread that would idle.
#pragma once

#include "progress.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace developable {

/// A task that begins on another thread before it is known whether it is needed. What comes of it is taken,
/// or it is abandoned: then its progress asks it to stop.
class TaskAhead {
public:
	using Run = std::function<void(const Progress&)>;

	explicit TaskAhead(Run run) : run_(std::move(run)) {}
	TaskAhead(const TaskAhead&) = delete;
	TaskAhead& operator=(const TaskAhead&) = delete;
	/// Abandons it, and waits until it has stopped.
	~TaskAhead();

	/// Where no other thread can be had it does not begin.
	void begin();
	bool begun() const { return thread_.joinable(); }
	/// Whether it has run to its end.
	bool ended() const;

	/// Waits for the end of a task that has begun, and tells how far it is; a stop that the progress asks for
	/// is handed on. \throws what the task has thrown
	void finish(const Progress& progress);

private:
	void work();

	const Run run_;
	std::thread thread_;
	mutable std::mutex mutex_;
	std::condition_variable end_;
	bool ended_ = false, stop_ = false;
	double fraction_ = 0;
	std::string message_;
	std::exception_ptr error_;
};

} // namespace developable
