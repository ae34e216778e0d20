// SPDX-License-Identifier: GPL-3.0-or-later
// panel_verdicts.h: what is known of panels, or is being found out on some thread.
#pragma once

#include "panel_test.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>

namespace developable::detail {

/// Verdicts on panels, each found once, by whichever thread asks first.
class PanelVerdicts {
public:
	/// \return nothing where it was asked to stop
	using Find = std::function<std::optional<PanelVerdict>()>;

	/// Whether it is known, or some thread is about to know it.
	bool has(const TriangleMesh& panel) const;
	/// Notes that a verdict is wanted. \return whether for the first time
	bool want(const TriangleMesh& panel);

	/// Finds what is not known, or waits until another thread has.
	/// \return nothing where it, or the progress, was asked to stop
	std::optional<PanelVerdict> on(const TriangleMesh& panel, const Progress& progress, const Find& find);

	/// To be called while no thread finds any.
	void forget() { entries_.clear(); }

private:
	/// What a verdict depends on, within a patch.
	using Key = std::pair<std::vector<double>, std::vector<int>>; // vertices, triangles
	enum class State { Unknown, UnderWay, Known };
	struct Entry {
		State state = State::Unknown;
		bool wanted = false;
		PanelVerdict verdict;
	};
	/// Tells others when a verdict is found, or is not to be had from this thread.
	class Finder;

	static Key keyOf(const TriangleMesh& panel);

	mutable std::mutex mutex_;
	std::condition_variable change_;
	std::map<Key, Entry> entries_;
};

} // namespace developable::detail
