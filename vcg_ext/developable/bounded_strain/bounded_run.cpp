// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_run.cpp: steps, and when bounds harden between them.
#include "bounded_run.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace developable::detail {

namespace {

constexpr double elasticity = 1e-4;      // γ: too little to be seen in the shape
constexpr double slow = 0.9;             // decrease of φ that a step must promise, or the bounds harden
constexpr double settledDecrease = 0.02; // of φ, and of the distance: less means that the nearest is found
constexpr double settledDistance = 0.005;
constexpr int patience = 8;                 // steps that were no good
constexpr double smallCostOfRounding = 0.1; // as a share of the distance in φ: half as much of its root

/// The edge of the bending bound sharpens with those of strains, of which it is a multiple.
double bendingWidth(const RoundedPenalty& edge) {
	constexpr double ofStrain = 10, sharpest = 0.01;
	return std::max(ofStrain * edge.width, sharpest);
}

/// Of every patch, where bounds differ with the direction.
HeldGrain heldGrain(const PatchAssembly& assembly, const FlatPatterns& patterns,
					const StrainedTriangles& triangles, const Positions& start,
					const BoundedStrainOptions& options) {
	if (!options.bounds.directed)
		return {};
	std::vector<HeldGrain::Piece> pieces;
	pieces.reserve(assembly.patches.size());
	for (int piece = 0; piece < assembly.patchCount(); ++piece)
		pieces.push_back({trianglesOfPiece(triangles, assembly, piece), patterns.pieces[piece].longestSide});
	return HeldGrain(std::move(pieces), options.grain, start, patterns.positions);
}

} // namespace

BoundedRun::BoundedRun(const PatchAssembly& assembly, const FlatPatterns& patterns, const Positions& start,
					   const BoundedStrainOptions& options, double farthest, const BendingLimit& bending,
					   double firstStiffness, const Progress& progress)
	: assembly_(assembly), options_(options), progress_(progress), firstStiffness_(firstStiffness),
	  nearness_(nearness(assembly, options.smoothness, options.fairness)), bound_(assembly, farthest),
	  bending_(assembly, bending),
	  penalty_(strainedTriangles(assembly, start, patterns), options.bounds, elasticity),
	  grain_(heldGrain(assembly, patterns, penalty_.triangles(), start, options)),
	  steps_(assembly, nearness_, bound_, bending_, penalty_, grain_), unknowns_{start, patterns.positions} {
	penalty_.watchBorder(patterns.positions);
	if (!options.bounds.directed)
		return;
	std::vector<double> ofTriangles;
	for (const int patch : assembly.patchOfTriangle)
		ofTriangles.push_back(grain_.angles()[std::size_t(patch)]);
	penalty_.setGrain(std::move(ofTriangles));
}

BoundedEnding BoundedRun::run() {
	Hardening hardening(penalty_, firstStiffness_);
	const double startViolation = violation();
	double distance = 0, beyond = startViolation;
	std::vector<double> violations; // before each hardening
	for (int idle = 0; idle < patience;) {
		if (iterations_ >= options_.maxIterations)
			return BoundedEnding::OutOfSteps;
		if (!mayGoOn(startViolation, beyond))
			return BoundedEnding::Stopped;
		++iterations_;
		bending_.harden(bendingWidth(penalty_.edge()));
		const double decrease = steps_.step(unknowns_);
		if (!steps_.solvable())
			return BoundedEnding::Stuck;
		if (tooFar())
			return BoundedEnding::TooFar;
		const double before = distance;
		distance = steps_.distanceCost(unknowns_.shape);
		beyond = violation();
		const bool within = beyond <= options_.tolerance,
				   sharp = hardening.costOfRounding() <= smallCostOfRounding * distance,
				   settled = decrease < settledDecrease &&
							 std::abs(distance - before) <= settledDistance * distance;
		if (settled && within && sharp)
			return BoundedEnding::Within;
		if (decrease == 0) {
			hardening.soften();
			violations.clear();
			++idle;
		} else if (decrease < slow && within && !sharp) {
			hardening.sharpen();
		} else if (decrease < slow) {
			violations.push_back(beyond);
			if (hopeless(violations) || (!hardening.harden() && settled))
				return BoundedEnding::Stuck;
		}
	}
	return beyond <= options_.tolerance ? BoundedEnding::Within : BoundedEnding::Stuck;
}

double BoundedRun::violation() const {
	return penalty_.greatestViolation(unknowns_.shape, unknowns_.pattern);
}

bool BoundedRun::tooFar() const {
	return options_.meanOnWay > 0 &&
		   displacementMap(assembly_.originalPositions, unknowns_.shape).mean() > options_.meanOnWay;
}

bool BoundedRun::mayGoOn(double startViolation, double left) const {
	char text[120];
	std::snprintf(text, sizeof text, "%d steps: strains are at most %.3g %% beyond their bounds", iterations_,
				  100 * left);
	// The violation falls by orders of magnitude, which are what takes time.
	const double done = std::log(std::max(left, options_.tolerance) / startViolation) /
						std::log(std::min(options_.tolerance / startViolation, 0.5));
	return developable::mayGoOn(progress_, std::clamp(done, 0.0, 1.0), text);
}

} // namespace developable::detail
