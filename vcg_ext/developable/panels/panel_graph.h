// SPDX-License-Identifier: GPL-3.0-or-later
// panel_graph.h: shortest paths within a panel, from its border and cuts or between points of it.
#pragma once

#include "cut_surface.h"

#include <limits>

namespace developable::detail {

/// The copies of a panel with the half edges between them that are not cut.
class PanelGraph {
public:
	/// \param held  per triangle whether it is held: no path runs between two of these; or empty
	PanelGraph(const CutSurface& surface, int panel, const std::vector<char>& held);

	bool has(int copy) const { return inside_[copy] != 0; }
	/// Cuts are borders, too.
	bool onBorder(int copy) const { return onBorder_[copy] != 0; }

	/// Shortest paths from some copies, over copies inside the panel.
	struct Paths {
		std::vector<double> length; ///< per copy; +∞ where none leads
		std::vector<int> halfEdge;  ///< per copy, of the step to it; -1 at the beginning

		bool reach(int copy) const { return length[copy] < std::numeric_limits<double>::infinity(); }
	};

	Paths from(const std::vector<int>& copies) const;
	Paths fromBorder() const { return from(border_); }

	/// The half edges of the path to a copy.
	std::vector<int> wayTo(int copy, const Paths& paths) const;

	/// The nearest copy to a point; -1: there is none.
	int nearestTo(const Eigen::Vector3d& point) const;

private:
	int otherEnd(int h, int copy) const {
		return surface_.startOf(h) == copy ? surface_.endOf(h) : surface_.startOf(h);
	}

	const CutSurface& surface_;
	std::vector<char> inside_, onBorder_; // per copy
	std::vector<int> border_;
	std::vector<std::vector<int>> halfEdges_; // per copy
};

} // namespace developable::detail
