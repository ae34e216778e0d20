// SPDX-License-Identifier: GPL-3.0-or-later
// penalty_method.cpp: the outer steps of the paper's global method, each with a larger penalty.
#include "penalty_method.h"

#include "developable/geometry/geometry.h"
#include "penalty_function.h"
#include "polak_ribiere.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace developable {

namespace {

std::string removedShare(double now, double start) {
	char text[64];
	std::snprintf(text, sizeof text, "%.1f %% of the detect function removed", 100 * (1 - now / start));
	return text;
}

void requireValid(const PenaltyMethodOptions& options) {
	requireOption(options.angleTolerance >= 0, "The angle tolerance must not be negative.");
	requireOption(options.relativeChange >= 0, "The relative change must not be negative.");
	requireOption(options.maxIterations >= 0, "The limit of iterations must not be negative.");
}

} // namespace

OptimizationReport penaltyMethod(const PatchAssembly& assembly, Positions& positions,
								 const PenaltyMethodOptions& options, const Progress& progress) {
	constexpr int conjugateGradientSteps = 5; // as the paper has it
	requireValid(options);
	requireOpenPatches(assembly);
	OptimizationReport report;
	Eigen::VectorXd defects = angleDefects(assembly, positions);
	const double start = detectFunction(defects);
	const auto developable = [&] { return largestAngleDefect(defects) <= options.angleTolerance; };
	if (start == 0 || developable())
		return report;
	requireFreePlaces(assembly);

	detail::PenaltyFunction function(assembly);
	detail::PolakRibiere conjugateGradients(0.01 * meanEdgeLength(assembly));
	Positions current = positions;
	double now = start;
	report.status = Status::LimitReached;
	while (report.iterations < options.maxIterations) {
		function.weighFor(now);
		const auto keepGoing = [&] {
			return mayGoOn(progress, double(report.iterations) / options.maxIterations,
						   "step " + std::to_string(report.iterations + 1) + ": " + removedShare(now, start));
		};
		if (!conjugateGradients.run(function, current, conjugateGradientSteps, keepGoing)) {
			report.status = Status::Stopped;
			return report;
		}
		++report.iterations;
		defects = angleDefects(assembly, current);
		const double before = std::exchange(now, detectFunction(defects));
		if (developable() || now == 0) {
			report.status = Status::Converged;
			break;
		}
		// What is not a number has not changed enough either.
		if (!(std::abs(now - before) / start >= options.relativeChange)) {
			report.status = Status::Stalled;
			break;
		}
	}
	positions = current;
	return report;
}

} // namespace developable
