// SPDX-License-Identifier: GPL-3.0-or-later
// tournament.h: who of many has the largest key, while keys change (the heap of Section 5.2).
#pragma once

#include "prefetch.h"

#include <algorithm>
#include <vector>

namespace developable::detail {

/// Holds some of the numbers 0 to n - 1, each with a key. The top has the largest key, and among equal keys
/// the smallest rank. A few meet in a match and its winner goes on to the next round: unlike in a heap each
/// has its seat, so that neighbours who change together share the matches that are played again.
class Tournament {
public:
	/// \param ranks  per number, all different; must outlive this
	explicit Tournament(const std::vector<int>& ranks);

	bool empty() const { return size_ == 0; }
	int size() const { return size_; }
	bool contains(int item) const {
		return firstRound_[item / firstMatchSize].keys[item % firstMatchSize] != absent;
	}
	int top() const { return top_.item; }
	double topKey() const { return top_.key; }

	/// Inserts an item, or gives it another key, 0 or more. What is not a number has no order: it takes the
	/// item out.
	void set(int item, double key) { change(item, key >= 0 ? key : absent); }

	void remove(int item) { change(item, absent); }

	/// Who is now among the best few dozen in the seat of an item, or -1: likely to be the top before long.
	/// Its own seats are fetched.
	int successor(int item) const {
		const int round = std::max(0, static_cast<int>(rounds_.size()) - 3);
		int seat = item / firstMatchSize;
		for (int i = 0; i < round; ++i)
			seat /= matchSize;
		const int found = rounds_[round][seat / matchSize].players[seat % matchSize].item;
		if (found >= 0) {
			prefetch(&firstRound_[found / firstMatchSize]);
			prefetch(&rounds_[0][found / firstMatchSize / matchSize]);
		}
		return found;
	}

private:
	static constexpr int firstMatchSize = 8, matchSize = 4; // each fills a cache line
	static constexpr double absent = -1;

	struct Player {
		double key = absent;
		int item = -1;
	};

	struct alignas(64) FirstMatch {
		double keys[firstMatchSize] = {absent, absent, absent, absent, absent, absent, absent, absent};
	};

	struct alignas(64) Match {
		Player players[matchSize];
	};

	bool beats(const Player& a, const Player& b) const {
		return a.key > b.key || (a.key == b.key && a.key != absent && ranks_[a.item] < ranks_[b.item]);
	}

	Player winner(const FirstMatch& match, int firstItem) const {
		Player best;
		for (int i = 0; i < firstMatchSize; ++i) {
			const Player player = {match.keys[i], firstItem + i};
			if (beats(player, best))
				best = player;
		}
		return best;
	}

	Player winner(const Match& match) const {
		Player best = match.players[0];
		for (int i = 1; i < matchSize; ++i)
			if (beats(match.players[i], best))
				best = match.players[i];
		return best;
	}

	/// Plays a match again only where its winner was the one who changed.
	void change(int item, double key) {
		int seat = item / firstMatchSize;
		FirstMatch& match = firstRound_[seat];
		double& own = match.keys[item % firstMatchSize];
		size_ += (key != absent) - (own != absent);
		own = key;
		Player challenger = {key, item};
		int replaced = item;
		for (std::size_t round = 0; round < rounds_.size(); ++round) {
			Player& holder = rounds_[round][seat / matchSize].players[seat % matchSize];
			if (holder.item == replaced)
				challenger =
					round == 0 ? winner(match, seat * firstMatchSize) : winner(rounds_[round - 1][seat]);
			else if (!beats(challenger, holder))
				return;
			replaced = holder.item;
			holder = challenger;
			seat /= matchSize;
		}
		top_ = winner(rounds_.back().front());
	}

	const std::vector<int>& ranks_;
	std::vector<FirstMatch> firstRound_;
	std::vector<std::vector<Match>> rounds_;
	Player top_;
	int size_ = 0;
};

} // namespace developable::detail
