// SPDX-License-Identifier: GPL-3.0-or-later
// box_tree.cpp: builds the tree from the things upwards, and searches it level by level, from the top.
#include "box_tree.h"

#include <algorithm>
#include <utility>

namespace developable {

BoxTree::BoxTree(std::vector<Box> boxes) {
	levels_.push_back(std::move(boxes));
	while (levels_.back().size() > arity) {
		const std::vector<Box>& below = levels_.back();
		std::vector<Box> level((below.size() + arity - 1) / arity, emptyBox());
		for (std::size_t i = 0; i < below.size(); ++i)
			level[i / arity] = level[i / arity].min(below[i]);
		levels_.push_back(std::move(level));
	}
}

void BoxTree::extend(std::size_t item, const Box& box) {
	for (std::vector<Box>& level : levels_) {
		if (contains(level[item], box))
			return;
		level[item] = level[item].min(box);
		item /= arity;
	}
}

const std::vector<int>& BoxTree::near(const Box& box) {
	const Box inner = core(box);
	found_.assign(1, 0);
	for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
		nodes_.swap(found_);
		found_.resize(arity * nodes_.size());
		int* next = found_.data();
		for (const int node : nodes_) {
			const std::size_t first = arity * node, end = std::min(first + arity, level->size());
			for (std::size_t item = first; item < end; ++item) {
				*next = static_cast<int>(item);
				next += contains((*level)[item], inner);
			}
		}
		found_.resize(next - found_.data());
	}
	return found_;
}

} // namespace developable
