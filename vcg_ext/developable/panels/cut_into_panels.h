// SPDX-License-Identifier: GPL-3.0-or-later
// cut_into_panels.h: the front door of panels/: any surface, open or closed, of any genus, is cut into few
// panels that can be made developable within a given distance, along short and smooth seams and darts.
//
// Nothing is moved. Raw clusters of normals (variational shape approximation: Cohen-Steiner, Alliez and
// Desbrun 2004) are joined greedily across their longest seams, wherever the constrained Newton method says
// that the union still becomes developable; where a whole seam can't go, a part of it may stay as a dart.
// Seams are drawn anew as smooth curves, for which triangles are split.
#pragma once

#include "cut_mesh.h"
#include "panel_material.h"

#include "developable/mesh/mesh.h"

#include <string>
#include <vector>

namespace developable {

struct CutOptions {
	/// How far a vertex may move when the panels are made developable together, length; negative: 2 % of the
	/// diagonal of each part (what shares vertices or is sewn together), of the smallest box along any axes
	/// where there are no more than 2000 triangles.
	double maxDisplacement = -1;
	PanelMaterial material;  ///< what the panels may be strained by when they are laid flat
	int maxPanels = 0;       ///< 0: as many as it takes
	bool darts = true;       ///< seams may stay in part, as darts
	double creaseAngle = 40; ///< seams like to lie on edges whose faces turn by more than this, degrees
	/// Left and right panels of a surface that is its own mirror image mirror each other; without darts.
	bool symmetric = false;
	bool keepSelected = false;  ///< no seam or dart crosses a selected triangle
	bool splitTriangles = true; ///< where seams cross them; else seams keep to edges
};

/// One panel, and what becomes of it when all are made developable together.
struct CutPanel {
	int triangles = 0;
	double area = 0;          ///< length²
	bool developable = false; ///< or within what its material bears, and within the greatest displacement
	/// Why not: TooFar, NeedsCut or BeyondBounds; or why it has its longest seam: SeamTooFar and the like.
	Reason reason = Reason::AsStatus;
	int neighbour =
		-1; ///< the panel across its longest seam that was added, itself at a slit or dart; -1: none
	Eigen::Vector3d seamPoint = Eigen::Vector3d::Zero(); ///< half way along that
	double curvatureBefore = 0;                          ///< C, rad
	double curvatureAfter = 0;
	double maxAngleDefect = 0;   ///< after, rad
	double beyondBounds = 0;     ///< by how much a strain is beyond what the material bears, as a share
	double meanDisplacement = 0; ///< over its vertices, length
	double maxDisplacement = 0;
	Eigen::Vector3d worstPoint = Eigen::Vector3d::Zero(); ///< where most curvature is left, or most is moved
};

struct CutReport {
	/// Converged; NothingToDo: every patch is a panel already; NeedsCut: some panel can't be made developable
	/// within the distance; LimitReached: not with so few panels; Stopped.
	Status status = Status::NothingToDo;
	int darts = 0;
	double seamLength = 0; ///< each seam and dart that was added or that was there between patches, once
	double smallestPanelArea = 0;
	double meanDisplacement = 0; ///< over all vertices, when all panels are made developable together, length
	double maxDisplacement = 0;
	std::vector<CutPanel> panels;
	std::vector<std::string> notes; ///< what a user should know, in sentences
};

struct CutResult {
	CutMesh mesh;
	CutReport report;
};

/// \return  when stopped, nothing but a report that says so
/// \throws EmptyMesh, InvalidCoordinate, DegenerateTriangle, InvalidParameter
CutResult cutIntoPanels(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
						const Progress& progress = {});

} // namespace developable
