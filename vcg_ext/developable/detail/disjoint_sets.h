// SPDX-License-Identifier: GPL-3.0-or-later
// disjoint_sets.h: union and find over the numbers 0 to n - 1, and dense numbers for the sets.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace developable::detail {

/// A numbering of n elements by 0 to count - 1, in the order of first appearance.
struct Numbering {
	std::vector<int> number; ///< per element; -1 for those left out
	int count = 0;
};

class DisjointSets {
public:
	explicit DisjointSets(int size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

	int find(int element) {
		while (parent_[element] != element) {
			parent_[element] = parent_[parent_[element]];
			element = parent_[element];
		}
		return element;
	}

	/// The smaller root stays the root, so the outcome does not depend on the order of calls.
	void unite(int a, int b) {
		a = find(a);
		b = find(b);
		parent_[std::max(a, b)] = std::min(a, b);
	}

	Numbering numbering() {
		Numbering result;
		result.number.assign(parent_.size(), -1);
		for (int element = 0; element < static_cast<int>(parent_.size()); ++element) {
			const int root = find(element);
			if (result.number[root] < 0)
				result.number[root] = result.count++;
			result.number[element] = result.number[root];
		}
		return result;
	}

private:
	std::vector<int> parent_;
};

} // namespace developable::detail
