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
	explicit IndexedHeap(int size) : key_(size, 0), slot_(size, -1) {}

	bool empty() const { return heap_.empty(); }
	int size() const { return static_cast<int>(heap_.size()); }
	bool contains(int item) const { return slot_[item] >= 0; }
	int top() const { return heap_.front(); }
	double topKey() const { return key_[heap_.front()]; }

	/// Inserts an item, or gives it another key.
	void set(int item, double key) {
		key_[item] = key;
		if (slot_[item] < 0) {
			slot_[item] = static_cast<int>(heap_.size());
			heap_.push_back(item);
		}
		siftDown(siftUp(slot_[item]));
	}

	void remove(int item) {
		const int slot = std::exchange(slot_[item], -1);
		const int last = heap_.back();
		heap_.pop_back();
		if (last == item)
			return;
		heap_[slot] = last;
		slot_[last] = slot;
		siftDown(siftUp(slot));
	}

private:
	// Four children a node: fewer levels, and siblings share a cache line.
	static constexpr int arity = 4;

	bool above(int a, int b) const { return key_[a] > key_[b] || (key_[a] == key_[b] && a < b); }

	void put(int slot, int item) {
		heap_[slot] = item;
		slot_[item] = slot;
	}

	int siftUp(int slot) {
		const int item = heap_[slot];
		while (slot > 0 && above(item, heap_[(slot - 1) / arity])) {
			put(slot, heap_[(slot - 1) / arity]);
			slot = (slot - 1) / arity;
		}
		put(slot, item);
		return slot;
	}

	void siftDown(int slot) {
		const int item = heap_[slot], count = static_cast<int>(heap_.size());
		while (slot * arity + 1 < count) {
			int best = slot * arity + 1;
			for (int child = best + 1; child <= slot * arity + arity && child < count; ++child)
				if (above(heap_[child], heap_[best]))
					best = child;
			if (!above(heap_[best], item))
				break;
			put(slot, heap_[best]);
			slot = best;
		}
		put(slot, item);
	}

	std::vector<double> key_;
	std::vector<int> slot_; // of each item in heap_, or -1
	std::vector<int> heap_;
};

} // namespace developable::detail
