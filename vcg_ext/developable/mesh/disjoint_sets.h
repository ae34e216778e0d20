// SPDX-License-Identifier: GPL-3.0-or-later
// disjoint_sets.h: union and find over the numbers 0 to n - 1, and dense numbers for the sets.
#pragma once

#include <vector>

namespace developable {

/// A numbering of n elements by 0 to count - 1, in the order of first appearance.
struct Numbering {
	std::vector<int> number; ///< per element; -1 for those left out
	int count = 0;
};

class DisjointSets {
public:
	explicit DisjointSets(int size);

	/// The element that stands for the set of this one.
	int find(int element);

	/// The smaller root stays the root, so the outcome does not depend on the order of calls.
	void unite(int a, int b);

	Numbering numbering();

private:
	std::vector<int> parent_;
};

} // namespace developable
