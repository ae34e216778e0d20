// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_panels.h: all panels made developable together, as the user will do.
#pragma once

#include "cut_into_panels.h"
#include "cut_surface.h"

#include <array>
#include <map>

namespace developable::detail {

/// What becomes of the panels, sewn together.
struct SewnPanels {
	std::vector<CutPanel> panels; ///< by the surface's numbers of panels; empty ones have no triangles
	/// Of those that overlap themselves when laid flat two points that lie upon each other then.
	std::map<int, std::array<Eigen::Vector3d, 2>> overlaps;
	/// Of these that overlap only where the two are near each other along the panel's border: the half edges
	/// of the surface from one to the other, wherever it does.
	std::map<int, std::vector<std::vector<int>>> notches;
	/// The shape that overlaps, 3 x corners of the surface's triangles; empty where none was laid flat.
	Positions corners;
	double meanDisplacement = 0;
	double maxDisplacement = 0;
	bool provisional = false; ///< seen briefly: the user's run may end otherwise
	bool coarse = false;      ///< on a coarse level
	double work = 0;          ///< that it took, in units of WorkBudget
};

/// A run on a coarse level of a large surface, that keeps to the limits from the first if it can, and goes
/// one other way at most where the first leads astray (with a material one that gives up early); as the user
/// will do it, without any other way; and with all of them.
enum class SewnRun { Brief, OneWay, Whole };

/// \param mesh             the panels as the user will have them: what comes out depends a little on
///                         the order of vertices; its `face` are triangles of the surface
/// \param maxDisplacement  per patch of the surface
/// \param material         without any strain all have to become developable
/// \param preferredMove    see NewtonTuning, share of the diagonal
SewnPanels developSewnPanels(const TriangleMesh& mesh, const CutSurface& surface,
							 const std::vector<double>& maxDisplacement, const PanelMaterial& material,
							 double preferredMove, SewnRun run, const Progress& progress);

/// What overlaps where the same shape is laid flat with other cuts: nearly as if all were sewn together anew,
/// in a fraction of the time.
/// \param mesh   as above
/// \param shape  of a surface with the same triangles
SewnPanels overlapsOfShape(const TriangleMesh& mesh, const CutSurface& surface, const SewnPanels& shape);

} // namespace developable::detail
