// SPDX-License-Identifier: GPL-3.0-or-later
// partial_assembly.h: an assembly of some triangles between the places of another one.
#pragma once

#include "patch_assembly.h"

namespace developable {

/// Some triangles of another assembly, which is the whole.
struct PartialAssembly {
	PatchAssembly assembly;
	std::vector<int> wholePlace; ///< per place, which one of the whole it is
	std::vector<int> wholePatch; ///< per patch, which one of the whole it is, or is of
};

/// \param triangles  3 x triangles, copies of the whole
PartialAssembly partialAssembly(const PatchAssembly& whole, const Eigen::Matrix3Xi& triangles);

/// The triangles for which a condition holds, 3 x triangles.
template <class Condition>
Eigen::Matrix3Xi trianglesWhere(const Eigen::Matrix3Xi& triangles, const Condition& condition) {
	std::vector<int> kept;
	for (int t = 0; t < triangles.cols(); ++t)
		if (condition(t))
			kept.push_back(t);
	return triangles(Eigen::all, kept);
}

} // namespace developable
