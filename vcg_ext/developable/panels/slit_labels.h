// SPDX-License-Identifier: GPL-3.0-or-later
// slit_labels.h: labels that tell the two sides of every cut apart, those of a panel's own slits too.
#pragma once

#include "seam_chains.h"

#include <map>
#include <utility>

namespace developable::detail {

/// A panel that has a slit or a dart is told by the clusters that it was joined from, any other by itself.
/// When the labels have been carried over to another surface of the same shape, the seams within panels that
/// were not there are opened again.
class SlitLabels {
public:
	/// \param surface   outlives this
	/// \param clusters  per triangle; both sides of any cut differ
	SlitLabels(const CutSurface& surface, const std::vector<int>& clusters);

	const std::vector<int>& labels() const { return labels_; } ///< per triangle, from 0
	int count() const { return static_cast<int>(panelOfLabel_.size()); }

	/// A panel that has become a ring, as nothing lies between its two ends any more, gets a slit.
	/// \param labels  per triangle of the other surface, whose panels are the connected parts of these
	void openWithin(CutSurface& other, const std::vector<int>& labels) const;

private:
	enum class Evidence { Open, Cut, None };
	struct Meeting;
	using Meetings = std::map<std::pair<int, int>, Meeting>; // by two labels, ascending

	Meetings meetings() const;
	/// Whether a point is nearer to where two labels met openly or to where they were cut.
	static Evidence evidence(const Meeting& meeting, const Eigen::Vector3d& at);

	const CutSurface& surface_;
	std::vector<int> labels_;
	std::vector<int> panelOfLabel_;
	std::vector<int> eulerOfPanel_; // its characteristic, 1 at most
};

} // namespace developable::detail
