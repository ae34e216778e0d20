// SPDX-License-Identifier: GPL-3.0-or-later
// panel_verdicts.cpp: who finds a verdict, and who waits for it.
#include "panel_verdicts.h"

#include <utility>

namespace developable::detail {

class PanelVerdicts::Finder {
public:
	/// With the lock on the entries held.
	Finder(PanelVerdicts& verdicts, Entry& entry) : verdicts_(verdicts), entry_(entry) {
		entry_.state = State::UnderWay;
	}
	Finder(const Finder&) = delete;
	Finder& operator=(const Finder&) = delete;
	~Finder() {
		const std::lock_guard lock(verdicts_.mutex_);
		entry_.state = found_ ? State::Known : State::Unknown;
		if (found_)
			entry_.verdict = *found_;
		verdicts_.change_.notify_all();
	}

	std::optional<PanelVerdict> run(const Find& find) { return found_ = find(); }

private:
	PanelVerdicts& verdicts_;
	Entry& entry_;
	std::optional<PanelVerdict> found_;
};

PanelVerdicts::Key PanelVerdicts::keyOf(const TriangleMesh& panel) {
	return {{panel.positions.data(), panel.positions.data() + panel.positions.size()},
			{panel.triangles.data(), panel.triangles.data() + panel.triangles.size()}};
}

bool PanelVerdicts::has(const TriangleMesh& panel) const {
	const Key key = keyOf(panel);
	const std::lock_guard lock(mutex_);
	const auto entry = entries_.find(key);
	return entry != entries_.end() && entry->second.state != State::Unknown;
}

bool PanelVerdicts::want(const TriangleMesh& panel) {
	Key key = keyOf(panel);
	const std::lock_guard lock(mutex_);
	return !std::exchange(entries_[std::move(key)].wanted, true);
}

std::optional<PanelVerdict> PanelVerdicts::on(const TriangleMesh& panel, const Progress& progress,
											  const Find& find) {
	Key key = keyOf(panel);
	std::unique_lock lock(mutex_);
	Entry& entry = entries_[std::move(key)];
	while (entry.state == State::UnderWay) {
		lock.unlock();
		const bool goOn = mayGoOn(progress, 0, "waiting for another thread's test");
		lock.lock();
		if (!goOn)
			return {};
		change_.wait_for(lock, betweenLooks, [&] { return entry.state != State::UnderWay; });
	}
	if (entry.state == State::Known)
		return entry.verdict;
	Finder finder(*this, entry);
	lock.unlock();
	return finder.run(find);
}

} // namespace developable::detail
