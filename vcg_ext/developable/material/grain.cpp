// SPDX-License-Identifier: GPL-3.0-or-later
// grain.cpp: directions of the model from a choice or a vector.
#include "grain.h"

#include "developable/mesh/mesh.h"

namespace developable {

Grain::Grain(Choice choice) {
	if (choice != LongestSeam)
		direction_[static_cast<int>(choice) - 1] = 1;
}

Grain::Grain(const Eigen::Vector3d& direction) : direction_(direction.stableNormalized()) {
	requireOption(direction_.allFinite() && !alongSeam(),
				  "The direction of the grain must be three numbers, and not all of them 0.");
}

} // namespace developable
