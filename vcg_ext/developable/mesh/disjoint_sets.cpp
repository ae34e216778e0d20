// SPDX-License-Identifier: GPL-3.0-or-later
// disjoint_sets.cpp: union by the smaller root, with path halving.
#include "disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace developable {

DisjointSets::DisjointSets(int size) : parent_(size) {
	std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int element) {
	while (parent_[element] != element) {
		parent_[element] = parent_[parent_[element]];
		element = parent_[element];
	}
	return element;
}

void DisjointSets::unite(int a, int b) {
	a = find(a);
	b = find(b);
	parent_[std::max(a, b)] = std::min(a, b);
}

Numbering DisjointSets::numbering() {
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

} // namespace developable
