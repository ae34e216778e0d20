// SPDX-License-Identifier: GPL-3.0-or-later
// penalty_method.h: the paper's global method (Section 4): penalty function and conjugate gradients.
#pragma once

#include "angle_defect.h"
#include "assemble_patches.h"
#include "detail/line_search.h"
#include "elastic_energy.h"
#include "progress.h"
#include "report.h"

#include <cstdio>

namespace developable {

struct PenaltyMethodOptions {
	double angleTolerance = 1e-4; ///< a copy with a smaller angle defect is a developable point, rad
	double relativeChange =
		1e-4;                ///< η: stop when an outer step changes G by less than this share of its start
	int maxIterations = 200; ///< N_max, outer steps
};

namespace detail {

/// J = E + ρ/2 · G² (Eq. 9) with its gradient (Eq. 10), as a function of the places' positions.
class PenaltyFunction {
public:
	explicit PenaltyFunction(const PatchAssembly& assembly)
		: assembly_(assembly), originalLengths_(edgeLengths(assembly, assembly.originalPositions)) {}

	/// Chooses ρ for the outer step that starts at this value of G: Σ l0² / (n_e · G²).
	void weighFor(double detectFunctionAtStart) {
		const double meanSquare = originalLengths_.squaredNorm() / originalLengths_.size();
		penalty_ = meanSquare / (detectFunctionAtStart * detectFunctionAtStart);
	}

	double value(const Positions& positions) const {
		const double g = detectFunction(angleDefects(assembly_, positions));
		return elasticEnergy(assembly_, positions, originalLengths_) + penalty_ / 2 * g * g;
	}

	/// 3 x places; 0 where a place is held still.
	Positions gradient(const Positions& positions) const {
		const Eigen::VectorXd defects = angleDefects(assembly_, positions);
		Positions result = elasticEnergyGradient(assembly_, positions, originalLengths_);
		result +=
			weightedDefectGradient(assembly_, positions, 2 * penalty_ * detectFunction(defects) * defects);
		for (int place = 0; place < assembly_.placeCount(); ++place)
			if (assembly_.placeFixed[place])
				result.col(place).setZero();
		return result;
	}

private:
	const PatchAssembly& assembly_;
	Eigen::VectorXd originalLengths_;
	double penalty_ = 0;
};

/// Conjugate gradients after Polak and Ribière. The direction turns back to the steepest descent whenever it
/// would not lead down.
class ConjugateGradient {
public:
	/// \param firstMove  the largest move of a place that the first line search tries, length
	explicit ConjugateGradient(double firstMove) : largestMove_(firstMove) {}

	/// Takes steps from the positions, beginning with the steepest descent.
	/// \return false when the run was asked to stop
	template <class KeepGoing>
	bool run(const PenaltyFunction& function, Positions& positions, int steps, KeepGoing keepGoing) {
		Positions gradient = function.gradient(positions), direction = -gradient;
		for (int step = 0; step < steps; ++step) {
			if (!keepGoing())
				return false;
			if (!(gradient.cwiseProduct(direction).sum() < 0))
				direction = -gradient;
			if (!advance(function, positions, gradient, direction))
				return true;
			if (step + 1 == steps)
				return true;
			const Positions next = function.gradient(positions);
			const double beta = next.cwiseProduct(next - gradient).sum() / gradient.squaredNorm();
			gradient = next;
			direction = std::max(beta, 0.0) * direction - gradient;
		}
		return true;
	}

private:
	/// \return false where no step leads down
	bool advance(const PenaltyFunction& function, Positions& positions, const Positions& gradient,
				 const Positions& direction) {
		const double slope = gradient.cwiseProduct(direction).sum();
		const double reach = std::sqrt(direction.colwise().squaredNorm().maxCoeff());
		if (!(slope < 0) || !(reach > 0))
			return false;
		const auto along = [&](double length) { return function.value(positions + length * direction); };
		const double length = lineSearch(along, function.value(positions), slope, largestMove_ / reach);
		if (length == 0)
			return false;
		positions += length * direction;
		largestMove_ = length * reach;
		return true;
	}

	double largestMove_;
};

inline std::string removedShare(double now, double start) {
	char text[64];
	std::snprintf(text, sizeof text, "%.1f %% of the detect function removed", 100 * (1 - now / start));
	return text;
}

} // namespace detail

/// Minimises E + ρ/2 · G² with a growing ρ (Section 4.1); linked copies move as one (Section 4.2).
/// \param positions  3 x places: in, the start; out, the result, or unchanged when stopped
/// \throws ClosedPatch, NothingFree
inline OptimizationReport penaltyMethod(const PatchAssembly& assembly, Positions& positions,
										const PenaltyMethodOptions& options, const Progress& progress = {}) {
	constexpr int conjugateGradientSteps = 5; // as the paper has it
	requireOpenPatches(assembly);
	OptimizationReport report;
	Eigen::VectorXd defects = angleDefects(assembly, positions);
	const double start = detectFunction(defects);
	const auto developable = [&] { return defects.cwiseAbs().maxCoeff() <= options.angleTolerance; };
	if (start == 0 || developable())
		return report;
	requireFreePlaces(assembly);

	detail::PenaltyFunction function(assembly);
	detail::ConjugateGradient conjugateGradient(0.01 * meanEdgeLength(assembly));
	Positions current = positions;
	double now = start;
	report.status = Status::LimitReached;
	while (report.iterations < options.maxIterations) {
		function.weighFor(now);
		const auto keepGoing = [&] {
			return mayGoOn(progress, double(report.iterations) / options.maxIterations,
						   "step " + std::to_string(report.iterations + 1) + ": " +
							   detail::removedShare(now, start));
		};
		if (!conjugateGradient.run(function, current, conjugateGradientSteps, keepGoing)) {
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
		if (std::abs(now - before) / start < options.relativeChange) {
			report.status = Status::Stalled;
			break;
		}
	}
	positions = current;
	return report;
}

} // namespace developable
