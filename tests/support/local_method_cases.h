// SPDX-License-Identifier: GPL-3.0-or-later
// local_method_cases.h: shapes for the local method, and the measures that its results are judged by.
#pragma once

#include "developable/geometry/geometry.h"
#include "support/shapes.h"

#include <cmath>

namespace developable::test {

/// With the angle tolerance that is the local method's default.
inline Measures measured(const PatchAssembly& assembly, const Positions& positions) {
	return measure(assembly, positions, 1e-4);
}

/// A cap that the paper's method does not finish.
inline PatchAssembly hardCase() {
	return assembled(jitteredGrid(11, 11, sphereCap(1.0)));
}

/// Two sheets sewn along an edge, with a ridge across the seam.
inline PatchAssembly sewnSheets() {
	const auto ridge = [](double u, double v) -> Eigen::Vector3d {
		return {u, v, 0.1 * std::exp(-20 * ((u - 1) * (u - 1) + (v - 0.5) * (v - 0.5)))};
	};
	return assembled(together(jitteredGrid(9, 9, ridge),
							  jitteredGrid(9, 9, [&](double u, double v) { return ridge(1 + u, v); })));
}

} // namespace developable::test
