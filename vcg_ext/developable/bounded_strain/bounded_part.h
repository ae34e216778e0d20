// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_part.h: one part of an assembly, by itself, from its start to a verdict.
#pragma once

#include "bounded_strain.h"

namespace developable::detail {

/// How a part ended.
struct BoundedOutcome {
	Status status = Status::NothingToDo;
	int iterations = 0;
	Positions positions;
	FlatPatterns patterns;         ///< of the positions
	Eigen::VectorXd beyondBounds;  ///< per triangle, as strain
	double nearestDevelopable = 0; ///< see OptimizationReport
};

/// Small parts are solved in several ways, of which the nearest result counts; see BoundedLevels for large
/// ones. Where no shape within the largest displacement was found, the same without that bound tells how far
/// the nearest is. \param part   the patches of an assembly that share places, see partsOf \param start  3 x
/// places; where it is farther from the original than places may go, the original serves
BoundedOutcome solveBounded(const PatchAssembly& part, const Positions& start,
							const BoundedStrainOptions& options, const Progress& progress);

} // namespace developable::detail
