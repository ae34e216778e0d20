// SPDX-License-Identifier: GPL-3.0-or-later
// bounded_strain.cpp: from the original, by bounds that harden, to a shape within them.
#include "bounded_strain.h"

#include "shape_and_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace developable {

namespace {

using namespace detail;

constexpr double elasticity = 1e-4;      // γ: too little to be seen in the shape
constexpr double slow = 0.9;             // decrease of φ that a step must promise, or the bounds harden
constexpr double settledDecrease = 0.02; // of φ, and of the distance: less means that the nearest is found
constexpr double settledDistance = 0.005;
constexpr double lastTolerance = 1e-4; // as flattenPatches has it
constexpr int patience = 8;            // steps that were no good

void requireValid(const BoundedStrainOptions& options) {
	requireValid(options.bounds);
	requireOption(options.bounds.any(),
				  "No strain is allowed: that is a task of the constrained Newton method.");
	requireOption(options.smoothness > 0 && options.smoothness <= 1,
				  "The smoothness must be greater than 0 and at most 1.");
	requireOption(options.maxIterations >= 0, "The limit of iterations must not be negative.");
	requireOption(options.tolerance > 0, "The tolerance of strains must be greater than 0.");
}

enum class Ending { Within, Stuck, OutOfSteps, Stopped };

/// One run from a shape with its pattern.
class Run {
public:
	Run(const PatchAssembly& assembly, const FlatPatterns& patterns, const Positions& start,
		const BoundedStrainOptions& options, const Progress& progress)
		: assembly_(assembly), patterns_(patterns), options_(options), progress_(progress),
		  penalty_(strainedTriangles(assembly, start, patterns), options.bounds, elasticity),
		  steps_(assembly, options.smoothness, penalty_), unknowns_{start, patterns.positions} {}

	Ending run() {
		Hardening hardening(penalty_);
		const double startViolation = violation();
		double distance = 0;
		for (int idle = 0; idle < patience;) {
			if (iterations_ >= options_.maxIterations)
				return Ending::OutOfSteps;
			if (!mayGoOn(startViolation))
				return Ending::Stopped;
			++iterations_;
			takeGrain();
			const double decrease = steps_.step(unknowns_);
			if (!steps_.solvable())
				return Ending::Stuck;
			const double before = distance;
			distance = squaredDistance();
			const bool settled =
				decrease < settledDecrease && std::abs(distance - before) <= settledDistance * distance;
			if (settled && violation() <= options_.tolerance)
				return Ending::Within;
			if (decrease == 0) {
				hardening.soften();
				++idle;
			} else if (decrease < slow) {
				hardening.harden();
			}
		}
		return violation() <= options_.tolerance ? Ending::Within : Ending::Stuck;
	}

	int iterations() const { return iterations_; }
	const Positions& shape() const { return unknowns_.shape; }
	double squaredDistance() const { return steps_.squaredDistance(unknowns_.shape); }
	Eigen::VectorXd violations() const { return penalty_.violations(unknowns_.shape, unknowns_.pattern); }

private:
	double violation() const { return violations().maxCoeff(); }

	void takeGrain() {
		if (options_.bounds.directed)
			penalty_.setGrain(grainOfTriangles(assembly_, unknowns_.shape, patterns_, penalty_.triangles(),
											   unknowns_.pattern));
	}

	bool mayGoOn(double startViolation) const {
		const double left = violation();
		char text[120];
		std::snprintf(text, sizeof text, "%d steps: strains are at most %.3g %% beyond their bounds",
					  iterations_, 100 * left);
		// The violation falls by orders of magnitude, which are what takes time.
		const double done = std::log(std::max(left, options_.tolerance) / startViolation) /
							std::log(std::min(options_.tolerance / startViolation, 0.5));
		return developable::mayGoOn(progress_, std::clamp(done, 0.0, 1.0), text);
	}

	const PatchAssembly& assembly_;
	const FlatPatterns& patterns_;
	const BoundedStrainOptions& options_;
	const Progress& progress_;
	StrainPenalty penalty_;
	ShapeAndPatternSteps steps_;
	ShapeAndPattern unknowns_;
	int iterations_ = 0;
};

Status statusOf(Ending ending, const PatchAssembly& assembly) {
	switch (ending) {
	case Ending::Within:
		return Status::Converged;
	case Ending::Stuck:
		return holdsPlaces(assembly) ? Status::Stalled : Status::NeedsCut;
	case Ending::OutOfSteps:
		return Status::LimitReached;
	case Ending::Stopped:
		return Status::Stopped;
	}
	return Status::Stalled;
}

/// How many patches are beyond the bounds, and where it is worst.
void describeNeedOfCut(const PatchAssembly& assembly, const Positions& positions,
					   const Eigen::VectorXd& violations, double tolerance, BoundedStrainReport& report) {
	std::vector<char> beyond(assembly.patchCount(), 0);
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if (violations[t] > tolerance)
			beyond[assembly.patchOfTriangle[t]] = 1;
	int worst = 0;
	violations.maxCoeff(&worst);
	const Eigen::Vector3d at = positions(Eigen::all, assembly.trianglePlaces.col(worst)).rowwise().mean();
	report.reason = Reason::BeyondBounds;
	report.patchesNeedingCut = static_cast<int>(std::count(beyond.begin(), beyond.end(), 1));
	report.worstPosition = {at[0], at[1], at[2]};
}

} // namespace

BoundedStrainReport boundedStrain(const PatchAssembly& assembly, Positions& positions,
								  const BoundedStrainOptions& options, const Progress& progress) {
	requireValid(options);
	requireFreePlaces(assembly);
	const Progress onwards = neverBack(progress);
	FlattenOptions flattening;
	flattening.bounds = options.bounds;
	flattening.grain = options.grain;
	const FlatPatterns patterns = flattenPatches(assembly, positions, flattening, partOf(onwards, 0, 0.05));
	BoundedStrainReport report;
	if (patterns.report.stopped) {
		report.status = Status::Stopped;
		return report;
	}
	report.beyondBounds = patterns.report.beyondBounds;
	if (report.beyondBounds <= lastTolerance) {
		report.reason = Reason::WithinBounds;
		return report;
	}
	const Progress ofRun = partOf(onwards, 0.05, 1);
	Run run(assembly, patterns, positions, options, ofRun);
	report.status = statusOf(run.run(), assembly);
	report.iterations = run.iterations();
	if (report.status == Status::Stopped)
		return report;
	positions = run.shape();
	report.squaredDistance = run.squaredDistance();
	Eigen::VectorXd violations = run.violations();
	if (report.status != Status::Converged) {
		// A pattern by itself is found more exactly than together with its shape.
		const FlatPatterns last = flattenPatches(assembly, positions, flattening);
		violations = beyondBounds(assembly, positions, last);
		if (last.report.beyondBounds <= lastTolerance)
			report.status = Status::Converged;
	}
	report.beyondBounds = violations.maxCoeff();
	if (report.status == Status::Converged)
		report.reason = Reason::WithinBounds;
	if (report.status == Status::NeedsCut)
		describeNeedOfCut(assembly, positions, violations, options.tolerance, report);
	return report;
}

} // namespace developable
