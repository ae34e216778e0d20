// SPDX-License-Identifier: GPL-3.0-or-later
// newton_problems.h: problems for the tests of steps, which go without the strategy above them.
#pragma once

#include "developable/newton/newton_problem.h"

#include "support/newton_checks.h"

namespace developable::test {

/// With the defaults of everything else.
inline detail::NewtonProblem problemOf(const PatchAssembly& assembly, const NewtonTuning& tuning = {}) {
	detail::NewtonProblem problem(assembly, {1e-4, 1e-4}, tuning, 0);
	problem.setSmoothness(3e-6);
	return problem;
}

} // namespace developable::test
