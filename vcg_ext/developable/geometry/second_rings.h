// SPDX-License-Identifier: GPL-3.0-or-later
// second_rings.h: the neighbours of vertex copies and their neighbours, few enough for any number of spokes.
#pragma once

#include "developable/mesh/mesh.h"

#include <vector>

namespace developable::detail {

/// Says which copies lie round each one: the vertices of all triangles that share a vertex with its own. Of a
/// neighbour with many spokes only some triangles are looked at, evenly spread and the same on both sides, so
/// that a fan of n spokes costs no more than n times as much as one of them; their choice hangs on the shape
/// of the fan alone and not on how anything is numbered.
class SecondRings {
public:
	static constexpr int mostTriangles = 64; ///< round a neighbour

	explicit SecondRings(const PatchAssembly& assembly);

	/// \param ring  becomes the copies, ascending, without the one asked for
	void collect(int copy, std::vector<int>& ring) const;

private:
	void orderFan(int copy);
	/// Follows the fan from a triangle's corner out over an edge of it. \return the corners on the way, the
	/// first one too; back at it when the fan is closed
	void walk(int corner, int exit, std::vector<int>& corners) const;
	void addTriangle(int corner, std::vector<int>& ring) const;
	/// The triangles round the copy at a corner, as seen from there.
	void addRound(int corner, std::vector<int>& ring) const;

	const PatchAssembly& assembly_;
	std::vector<int> fans_;         ///< as PatchAssembly::corners, but in their order round each copy
	std::vector<int> rankOfCorner_; ///< where it stands in its copy's fan
};

} // namespace developable::detail
