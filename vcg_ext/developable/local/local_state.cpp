// SPDX-License-Identifier: GPL-3.0-or-later
// local_state.cpp: the local method's shape at the start, and as the assembly numbers it.
#include "local_state.h"

namespace developable::detail {

LocalState::LocalState(const PatchAssembly& assembly, const Positions& positions,
					   AssemblingVertices assemblingVertices)
	: mesh_(assembly, positions, assemblingVertices) {
	for (int copy = 0; copy < mesh_.copyCount(); ++copy)
		mesh_.copies[copy].defect = newDefect(copy);
	detectFunction_ = developable::detectFunction(defects());
}

Eigen::VectorXd LocalState::defects() const {
	Eigen::VectorXd defects(mesh_.copyCount());
	for (int copy = 0; copy < mesh_.copyCount(); ++copy)
		defects[mesh_.originalCopy[copy]] = mesh_.copies[copy].defect;
	return defects;
}

Positions LocalState::positions() const {
	Positions positions(3, mesh_.placeCount());
	for (int place = 0; place < mesh_.placeCount(); ++place)
		positions.col(mesh_.originalPlace[place]) = mesh_.position(place);
	return positions;
}

} // namespace developable::detail
