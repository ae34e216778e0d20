// SPDX-License-Identifier: GPL-3.0-or-later
// options.h: how a mesh is cut into patches, and what of it may move.
#pragma once

namespace developable {

/// What separates two patches besides the edges that more or fewer than two faces share.
enum class SeamKind {
	ConnectedComponents, ///< nothing else
	FaceColour,          ///< edges between faces of different colour
	TextureIslands,      ///< edges where the texture coordinates jump
	FaceQuality          ///< edges between faces of different quality
};

/// How a mesh is read into a PatchAssembly.
struct PatchOptions {
	SeamKind seams = SeamKind::ConnectedComponents;
	double weldDistance = 0;   ///< vertices at most this far apart are linked, length; 0: equal coordinates
	bool onlySelected = false; ///< work on the patches that have a selected face; the others hold still
	bool fixBoundary = false;  ///< vertices on the boundary of a patch stay
	bool fixSelected = false;  ///< selected vertices stay
};

} // namespace developable
