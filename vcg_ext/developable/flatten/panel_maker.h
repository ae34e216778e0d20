// SPDX-License-Identifier: GPL-3.0-or-later
// panel_maker.h: takes the patches of an assembly apart into panels, their outside in front.
#pragma once

#include "panel_mesh.h"

namespace developable::detail {

/// Per triangle of the assembly whether it is turned round in its panel: those are that disagree with the
/// larger part of their patch's area, as the outside of the patch is where most of it faces.
/// \param positions  3 x places
std::vector<char> triangleTurned(const PatchAssembly& assembly, const Positions& positions);

/// Makes panels, and says how what is in the assembly is called in its panel.
class PanelMaker {
public:
	/// \param positions  3 x places
	PanelMaker(const PatchAssembly& assembly, const Positions& positions);

	/// Takes one patch out of the assembly. Its vertices are the patch's copies, ascending.
	PanelMesh panel(int patch) const;

	int panelCorner(int corner) const {
		return cornerOf(panelTriangle_[triangleOf(corner)], turned_[triangleOf(corner)]
																? (3 - cornerInTriangle(corner)) % 3
																: cornerInTriangle(corner));
	}

	/// In a triangle that is turned round the corners 0, 1, 2 become 0, 2, 1, so the half edges 0, 1, 2
	/// become 2, 1, 0.
	int panelHalfEdge(int halfEdge) const {
		return cornerOf(panelTriangle_[triangleOf(halfEdge)], turned_[triangleOf(halfEdge)]
																  ? 2 - cornerInTriangle(halfEdge)
																  : cornerInTriangle(halfEdge));
	}

private:
	const PatchAssembly& assembly_;
	const Positions& positions_;
	std::vector<char> turned_;       // per triangle of the assembly
	Groups trianglesOfPatch_;        // those of each patch, ascending
	std::vector<int> panelTriangle_; // per triangle of the assembly, its number in its panel
};

} // namespace developable::detail
