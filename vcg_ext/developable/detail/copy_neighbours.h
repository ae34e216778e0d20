// SPDX-License-Identifier: GPL-3.0-or-later
// copy_neighbours.h: which copies are adjacent to which, within their patch.
#pragma once

#include "../patch_assembly.h"

namespace developable::detail {

/// A range of copies, for range-based loops.
struct CopyRange {
	const int *first, *last;
	const int* begin() const { return first; }
	const int* end() const { return last; }
};

/// The adjacent copies of every copy, each once, in the order of its corners.
class CopyNeighbours {
public:
	explicit CopyNeighbours(const PatchAssembly& assembly) {
		start_.reserve(assembly.copyCount() + 1);
		neighbours_.reserve(2 * assembly.edgeCount());
		start_.push_back(0);
		for (int copy = 0; copy < assembly.copyCount(); ++copy) {
			for (int i = assembly.cornerStart[copy]; i < assembly.cornerStart[copy + 1]; ++i) {
				const int triangle = assembly.corners[i] / 3, corner = assembly.corners[i] % 3;
				addOnce(assembly.triangleCopies((corner + 1) % 3, triangle));
				addOnce(assembly.triangleCopies((corner + 2) % 3, triangle));
			}
			start_.push_back(static_cast<int>(neighbours_.size()));
		}
	}

	CopyRange of(int copy) const {
		return {neighbours_.data() + start_[copy], neighbours_.data() + start_[copy + 1]};
	}

private:
	void addOnce(int copy) {
		if (std::find(neighbours_.begin() + start_.back(), neighbours_.end(), copy) == neighbours_.end())
			neighbours_.push_back(copy);
	}

	std::vector<int> start_, neighbours_;
};

} // namespace developable::detail
