// SPDX-License-Identifier: GPL-3.0-or-later
// strain_bounds.cpp: what bounds are bounds.
#include "strain_bounds.h"

#include "developable/mesh/mesh.h"

namespace developable {

bool StrainBounds::any() const {
	for (const DirectionBounds& bounds : {warp, weft, bias})
		if (bounds.stretch > 0 || bounds.compression > 0)
			return true;
	return false;
}

void requireValid(const StrainBounds& bounds) {
	for (const DirectionBounds& direction : {bounds.warp, bounds.weft, bounds.bias}) {
		requireOption(direction.stretch >= 0 && direction.stretch <= 10,
					  "The allowed stretch must be from 0 to 1000 %.");
		requireOption(direction.compression >= 0 && direction.compression < 1,
					  "The allowed compression must be at least 0 and below 100 %: nothing can be pressed to "
					  "no length at all.");
	}
}

} // namespace developable
