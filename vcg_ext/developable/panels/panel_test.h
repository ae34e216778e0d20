// SPDX-License-Identifier: GPL-3.0-or-later
// panel_test.h: whether triangles make a panel: a disk that becomes developable within a given distance and
// lies flat without overlap.
#pragma once

#include "panel_material.h"

#include "developable/mesh/mesh.h"

namespace developable::detail {

/// What a panel may cost.
struct PanelLimits {
	double maxDisplacement = 0;  ///< of any vertex, length
	double meanDisplacement = 0; ///< over its vertices, length
	PanelMaterial material;
	/// Share of the border that may overlap itself when laid flat, but for a material: seams are drawn anew
	/// later, and what is left is closed.
	double notch = 0.03;
};

/// Why triangles are no panel.
enum class Obstacle {
	None,
	NoSheet,
	TooFar,
	Crumples, ///< it becomes developable by folds all over
	Overlaps,
	BeyondBounds,
	Unpromising ///< it was not looked into
};

struct PanelVerdict {
	bool flat =
		false; ///< it is a disk, or lies flat with its holes, and becomes developable within the limits
	bool disk = false; ///< or a flat sheet with holes
	Obstacle obstacle = Obstacle::None;
	double maxDisplacement = 0;
	double meanDisplacement = 0;
	Eigen::Vector3d worstPoint =
		Eigen::Vector3d::Zero(); ///< where the largest angle defect is left or was, or what moves too far
	double work = 0;             ///< what the test took, in units of WorkBudget

	bool isPanel() const { return flat && disk; }
};

/// \param mesh  a panel; vertices doubled along its slits and darts coincide
PanelVerdict testPanel(const TriangleMesh& mesh, const PanelLimits& limits, const Progress& progress = {});

/// The same, unless it is unpromising: when it is laid flat as it is, at a small part of the price, it
/// overlaps itself by much, or is strained more than such a move usually makes up for. Hardly any of those
/// are panels.
PanelVerdict testIfPromising(const TriangleMesh& mesh, const PanelLimits& limits,
							 const Progress& progress = {});

/// Whether triangles are one disk.
bool isDisk(const TriangleMesh& mesh);

} // namespace developable::detail
