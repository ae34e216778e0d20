// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/mesh/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace developable::test {
namespace {

constexpr int size = 60;

std::vector<std::pair<int, int>> randomPairs() {
	std::mt19937 random(5);
	std::vector<std::pair<int, int>> pairs(40);
	for (auto& [a, b] : pairs) {
		a = static_cast<int>(random() % size);
		b = static_cast<int>(random() % size);
	}
	return pairs;
}

/// Per element, the least of its set: by passing it on along the pairs until nothing changes.
std::vector<int> leastOfSets(const std::vector<std::pair<int, int>>& pairs) {
	std::vector<int> least(size);
	std::iota(least.begin(), least.end(), 0);
	for (bool changed = true; changed;) {
		changed = false;
		for (const auto& [a, b] : pairs) {
			changed = changed || least[a] != least[b];
			least[a] = least[b] = std::min(least[a], least[b]);
		}
	}
	return least;
}

TEST(DisjointSets, SetIsNamedByItsLeastElementInWhateverOrderItGrew) {
	std::vector<std::pair<int, int>> pairs = randomPairs();
	const std::vector<int> expected = leastOfSets(pairs);
	std::mt19937 random(6);
	for (int round = 0; round < 5; ++round) {
		DisjointSets sets(size);
		for (const auto& [a, b] : pairs)
			sets.unite(round % 2 ? a : b, round % 2 ? b : a);
		for (int element = 0; element < size; ++element)
			EXPECT_EQ(sets.find(element), expected[element]);
		std::shuffle(pairs.begin(), pairs.end(), random);
	}
}

TEST(DisjointSets, NumberingIsDenseAndInTheOrderOfFirstAppearance) {
	DisjointSets sets(7);
	sets.unite(6, 2);
	sets.unite(5, 1);
	sets.unite(3, 6);
	const Numbering numbering = sets.numbering();
	EXPECT_EQ(numbering.number, (std::vector<int>{0, 1, 2, 2, 3, 1, 2}));
	EXPECT_EQ(numbering.count, 4);
}

TEST(DisjointSets, ElementsAreAloneAtFirst) {
	EXPECT_EQ(DisjointSets(3).numbering().number, (std::vector<int>{0, 1, 2}));
	EXPECT_EQ(DisjointSets(0).numbering().count, 0);
	DisjointSets sets(3);
	sets.unite(1, 1);
	EXPECT_EQ(sets.numbering().count, 3);
}

} // namespace
} // namespace developable::test
