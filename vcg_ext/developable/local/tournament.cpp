// SPDX-License-Identifier: GPL-3.0-or-later
// tournament.cpp: the seats of a tournament.
#include "tournament.h"

namespace developable::detail {

Tournament::Tournament(const std::vector<int>& ranks) : ranks_(ranks) {
	std::size_t matches = (ranks.size() + firstMatchSize - 1) / firstMatchSize;
	firstRound_.resize(matches);
	do {
		matches = (matches + matchSize - 1) / matchSize;
		rounds_.emplace_back(matches);
	} while (matches > 1);
}

} // namespace developable::detail
