// SPDX-License-Identifier: GPL-3.0-or-later
// finite_differences.h: central differences (Eq. 12), which every closed-form derivative has to agree with.
#pragma once

#include "developable/mesh/mesh.h"

namespace developable::test {

/// The gradient of a function of positions, 3 x places.
template <class Function>
Positions centralDifferences(const Function& function, const Positions& at, double step = 1e-5) {
	Positions gradient(3, at.cols());
	Positions positions = at;
	for (Eigen::Index i = 0; i < at.size(); ++i) {
		positions.data()[i] = at.data()[i] + step;
		const double above = function(positions);
		positions.data()[i] = at.data()[i] - step;
		const double below = function(positions);
		positions.data()[i] = at.data()[i];
		gradient.data()[i] = (above - below) / (2 * step);
	}
	return gradient;
}

} // namespace developable::test
