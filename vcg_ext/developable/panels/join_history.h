// SPDX-License-Identifier: GPL-3.0-or-later
// join_history.h: of what two halves each panel was joined, so that a join can be taken back, and what could
// not be joined.
#pragma once

#include "cut_surface.h"

#include <array>
#include <map>
#include <set>

namespace developable::detail {

/// Panels are known by their triangles: these stay the same when others are joined or divided.
class JoinHistory {
public:
	/// Joins across some half edges, and remembers the halves.
	void join(CutSurface& surface, const std::vector<int>& halfEdges);

	/// Divides a panel into what it was joined of last; no two panels will be joined to that panel again.
	/// \return whether it was joined at all
	bool takeBack(CutSurface& surface, int panel);

	/// No two panels will be joined to this one again.
	void neverAgain(const CutSurface& surface, int panel) { takenBack_.insert(surface.trianglesOf(panel)); }

	/// What could not be joined across some half edges can't be until one of the two panels changes.
	void refuse(const CutSurface& surface, const std::vector<int>& halfEdges);
	bool wasRefused(const CutSurface& surface, const std::vector<int>& halfEdges);

	/// Forgets what was refused.
	void tryAllAgain() { refused_.clear(); }

private:
	using Pair = std::array<int, 2>; ///< ascending

	/// A number for each set of triangles that ever was a panel.
	int numberOf(const CutSurface& surface, int panel);
	Pair pairAt(const CutSurface& surface, int halfEdge);

	std::map<std::vector<int>, int> numbers_; ///< by triangles, ascending
	std::map<int, std::vector<int>> halves_;  ///< the triangles of one half, by the whole's number
	std::set<std::vector<int>> takenBack_;    ///< the triangles of whole panels
	std::set<std::pair<Pair, int>> refused_;  ///< with the least half edge between them
};

} // namespace developable::detail
