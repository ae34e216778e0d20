// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_run.h: from a shape with its pattern, by bounds that harden, to the nearest shape within them.
#pragma once

#include "bounded_strain.h"
#include "shape_and_pattern.h"

namespace developable::detail {

enum class BoundedEnding { Within, Stuck, TooFar, OutOfSteps, Stopped };

/// One run on one level.
class BoundedRun {
public:
	/// \param farthest        how far places may go, length; positive
	/// \param firstStiffness  κ to begin with, see Hardening
	BoundedRun(const PatchAssembly& assembly, const FlatPatterns& patterns, const Positions& start,
			   const BoundedStrainOptions& options, double farthest, const BendingLimit& bending,
			   double firstStiffness, const Progress& progress);

	BoundedEnding run();

	int iterations() const { return iterations_; }
	Positions shape() const { return bound_.within(unknowns_.shape); }

private:
	double violation() const;
	bool tooFar() const;
	bool mayGoOn(double startViolation, double left) const;

	const PatchAssembly& assembly_;
	const BoundedStrainOptions& options_;
	const Progress& progress_;
	const double firstStiffness_;
	const Nearness nearness_;
	const DisplacementBound bound_;
	BendingBound bending_;
	StrainPenalty penalty_;
	HeldGrain grain_;
	ShapeAndPatternSteps steps_;
	ShapeAndPattern unknowns_;
	int iterations_ = 0;
};

} // namespace developable::detail
