// SPDX-License-Identifier: GPL-3.0-or-later
// indexed_heap.h: a maximum heap whose entries can change their key or leave (Section 5.2).
#pragma once

#include <utility>
#include <vector>

namespace developable::detail {

/// Holds some of the numbers 0 to n - 1, each with a key. The top has the largest key, and among equal keys
/// the smallest number, so that it does not depend on the heap's history.
class IndexedHeap {
public:
	explicit IndexedHeap(int size) : slot_(size, -1) {}

	bool empty() const { return heap_.empty(); }
	int size() const { return static_cast<int>(heap_.size()); }
	bool contains(int item) const { return slot_[item] >= 0; }
	int top() const { return heap_.front().item; }
	double topKey() const { return heap_.front().key; }

	/// Inserts an item, or gives it another key.
	void set(int item, double key) {
		if (slot_[item] < 0) {
			slot_[item] = size();
			heap_.emplace_back();
		}
		sift(slot_[item], {key, item});
	}

	void remove(int item) {
		const int slot = std::exchange(slot_[item], -1);
		const Entry last = heap_.back();
		heap_.pop_back();
		if (last.item != item)
			sift(slot, last);
	}

private:
	// Four children a node: fewer levels, and siblings with their keys fill one cache line.
	static constexpr int arity = 4;

	struct Entry {
		double key = 0;
		int item = 0;

		bool isAbove(const Entry& other) const {
			return key > other.key || (key == other.key && item < other.item);
		}
	};

	void put(int slot, const Entry& entry) {
		heap_[slot] = entry;
		slot_[entry.item] = slot;
	}

	/// Puts an entry where it belongs, above or below a slot that is free.
	void sift(int slot, const Entry& entry) {
		while (slot > 0 && entry.isAbove(heap_[(slot - 1) / arity])) {
			put(slot, heap_[(slot - 1) / arity]);
			slot = (slot - 1) / arity;
		}
		while (slot * arity + 1 < size()) {
			int best = slot * arity + 1;
			for (int child = best + 1; child <= slot * arity + arity && child < size(); ++child)
				if (heap_[child].isAbove(heap_[best]))
					best = child;
			if (!heap_[best].isAbove(entry))
				break;
			put(slot, heap_[best]);
			slot = best;
		}
		put(slot, entry);
	}

	std::vector<int> slot_; // of each item in heap_, or -1
	std::vector<Entry> heap_;
};

} // namespace developable::detail
