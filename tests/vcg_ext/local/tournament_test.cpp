// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local/tournament.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace developable::test {
namespace {

TEST(Tournament, HandsOutTheLargestKeyFirstWhateverItsHistory) {
	for (const int count : {1, 7, 33, 200}) {
		std::mt19937 random(3);
		std::vector<int> ranks(count);
		std::iota(ranks.begin(), ranks.end(), 0);
		std::shuffle(ranks.begin(), ranks.end(), random);
		detail::Tournament tournament(ranks);
		std::vector<double> keys(count, -1); // by rank
		for (int round = 0; round < 5000; ++round) {
			const int item = static_cast<int>(random() % count);
			double& key = keys[ranks[item]];
			EXPECT_EQ(tournament.contains(item), key >= 0);
			key = random() % 4 == 0 ? -1 : static_cast<double>(random() % 50);
			if (key < 0)
				tournament.remove(item);
			else
				tournament.set(item, key);
			const auto largest = std::max_element(keys.begin(), keys.end()); // the first of equals
			ASSERT_EQ(tournament.size(),
					  std::count_if(keys.begin(), keys.end(), [](double k) { return k >= 0; }));
			ASSERT_EQ(tournament.empty(), *largest < 0);
			if (!tournament.empty()) {
				ASSERT_EQ(ranks[tournament.top()], largest - keys.begin());
				ASSERT_EQ(tournament.topKey(), *largest);
			}
		}
	}
}

TEST(Tournament, TakesOutWhatIsNotANumber) {
	const std::vector<int> ranks = {0, 1, 2};
	detail::Tournament tournament(ranks);
	tournament.set(0, 1);
	tournament.set(1, std::nan(""));
	EXPECT_EQ(tournament.size(), 1);
	EXPECT_EQ(tournament.top(), 0);
}

} // namespace
} // namespace developable::test
