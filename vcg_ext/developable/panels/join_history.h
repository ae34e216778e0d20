// SPDX-License-Identifier: GPL-3.0-or-later
// join_history.h: of what two halves each panel was joined, so that a join can be taken back.
#pragma once

#include "cut_surface.h"

#include <map>
#include <set>

namespace developable::detail {

/// Panels are known by their triangles, ascending: these stay the same when others are joined or divided.
class JoinHistory {
public:
	/// Joins across some half edges, and remembers the halves.
	void join(CutSurface& surface, const std::vector<int>& halfEdges);

	/// Divides a panel into what it was joined of last; these two will not be joined again.
	/// \return whether it was joined at all
	bool takeBack(CutSurface& surface, int panel);

	/// Whether a join that would make a panel of these triangles was taken back.
	bool wasTakenBack(const std::vector<int>& triangles) const { return takenBack_.count(triangles) > 0; }

private:
	std::map<std::vector<int>, std::vector<int>> halves_; ///< one half by the whole
	std::set<std::vector<int>> takenBack_;
};

} // namespace developable::detail
