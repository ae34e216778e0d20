// SPDX-License-Identifier: GPL-3.0-or-later
// lists.h: many short lists of numbers in one array.
#pragma once

#include <algorithm>
#include <vector>

namespace developable::detail {

/// One of the lists, for range-based loops.
struct ListRange {
	const int *first, *last;
	const int* begin() const { return first; }
	const int* end() const { return last; }
	int size() const { return static_cast<int>(last - first); }
};

/// Filled list by list: begin() before each of them, and once more after the last.
class Lists {
public:
	void begin() { start_.push_back(static_cast<int>(items_.size())); }
	void add(int item) { items_.push_back(item); }
	/// Adds an item unless the list has it. Lists are short.
	void addOnce(int item) {
		if (std::find(items_.begin() + start_.back(), items_.end(), item) == items_.end())
			items_.push_back(item);
	}

	ListRange of(int list) const { return {items_.data() + start_[list], items_.data() + start_[list + 1]}; }

private:
	std::vector<int> start_, items_;
};

} // namespace developable::detail
