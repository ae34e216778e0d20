// SPDX-License-Identifier: GPL-3.0-or-later
// cut_surface.h: an assembly with a panel for every triangle and cuts between joined triangles.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

#include <algorithm>
#include <vector>

namespace developable::detail {

/// Panels on an assembly. Its patches are never joined; within them triangles of different panels always
/// have a cut between them, and cuts inside a panel are slits and darts.
class CutSurface {
public:
	/// All of a patch is one panel.
	explicit CutSurface(PatchAssembly assembly);

	const PatchAssembly& assembly() const { return assembly_; }
	const Positions& positions() const { return assembly_.originalPositions; }
	int panelCount() const { return static_cast<int>(triangles_.size()); }
	/// Without those that were joined to others.
	int usedPanelCount() const {
		return static_cast<int>(std::count_if(triangles_.begin(), triangles_.end(),
											  [](const auto& triangles) { return !triangles.empty(); }));
	}
	int panelOf(int triangle) const { return panelOf_[triangle]; }
	const std::vector<int>& panels() const { return panelOf_; }
	/// Ascending; none of a panel that was joined to another.
	const std::vector<int>& trianglesOf(int panel) const { return triangles_[panel]; }

	/// Of the one or two panels that meet at a half edge, ascending.
	std::vector<int> trianglesAtBothSides(int halfEdge) const;

	/// The half edge across, or -1 where there is a border, a seam or a dart.
	int across(int halfEdge) const { return cut_[halfEdge] ? -1 : assembly_.across(halfEdge); }
	/// Whether a seam or a dart that was added runs there.
	bool isCut(int halfEdge) const { return cut_[halfEdge] != 0; }
	void setCut(int halfEdge, bool cut);

	int startOf(int halfEdge) const { return assembly_.copyAt(halfEdge); }
	int endOf(int halfEdge) const { return assembly_.copyAt(nextCorner(halfEdge)); }
	Eigen::Vector3d vectorOf(int halfEdge) const;
	double length(int halfEdge) const { return vectorOf(halfEdge).norm(); }
	Eigen::Vector3d middleOf(int halfEdge) const {
		return positions().col(assembly_.placeAt(halfEdge)) + vectorOf(halfEdge) / 2;
	}
	Eigen::Vector3d barycentre(int triangle) const {
		return (middleOf(3 * triangle) + middleOf(3 * triangle + 1) + middleOf(3 * triangle + 2)) / 3;
	}
	double area(int panel) const;
	double patchArea(int patch) const { return patchAreas_[patch]; }

	/// The triangles of a panel fall apart into those with different labels, each connected part a panel;
	/// cuts inside a panel that borders nothing else stay.
	/// \param labels  per triangle of the panel
	void divide(int panel, const std::vector<int>& labels);

	/// Opens a cut between two panels, or within one; what was two is one with a new number.
	/// \return the panel that holds both
	int join(const std::vector<int>& halfEdges);

	/// All labels anew: panels are the connected parts of triangles with equal labels. Other cuts go.
	/// \param labels  per triangle
	void relabel(const std::vector<int>& labels);

	/// Labels of which each is one connected part: of what has the same label the largest part keeps it, the
	/// others take that of which they have the longest border.
	/// \param labels  per triangle
	std::vector<int> withoutFragments(std::vector<int> labels) const;

	/// Some triangles as a mesh of their own, vertices doubled along cuts: vertex i is a fan of triangles at
	/// a place.
	/// \param triangles  ascending
	TriangleMesh meshOf(const std::vector<int>& triangles) const;

	/// Whether so much of the angle defect is at one place that no panel can have it inside, per copy.
	bool isSharpPoint(int copy) const { return sharp_[copy] != 0; }

	/// Unit normals, all on one side within a patch, 3 x triangles; and areas.
	const Eigen::Matrix3Xd& normals() const { return normals_; }
	const Eigen::VectorXd& areas() const { return areas_; }

private:
	PatchAssembly assembly_;
	std::vector<char> cut_; // per half edge, both of an edge
	std::vector<int> panelOf_;
	std::vector<char> sharp_;
	std::vector<std::vector<int>> triangles_;
	Eigen::Matrix3Xd normals_;
	Eigen::VectorXd areas_;
	Eigen::VectorXd patchAreas_;
};

/// 1 of a disk, 0 of a ring; 2 of a panel that is none at all.
int eulerCharacteristic(const CutSurface& surface, int panel);

} // namespace developable::detail
