// SPDX-License-Identifier: GPL-3.0-or-later
// newton_run.cpp: the guarded descent, and what is told of a run.
#include "newton_run.h"

#include <cstdio>

namespace developable::detail {

namespace {

/// What of the total absolute curvature is gone after some steps, in words. A run that began at a developable
/// shape has more on its way than at first.
std::string describeCurvature(double start, double left, int steps) {
	char text[160];
	if (left > start)
		std::snprintf(text, sizeof text, "%d steps: %.3g rad of the total absolute curvature to remove",
					  steps, left);
	else
		std::snprintf(text, sizeof text,
					  "%d steps: %.4g %% of the total absolute curvature removed, %.3g rad left", steps,
					  100 * (1 - left / start), left);
	return text;
}

} // namespace

void pullBack(const Positions& original, const Positions& from, Positions& move, double farthest) {
	for (int place = 0; place < move.cols(); ++place) {
		const Eigen::Vector3d displacement = from.col(place) + move.col(place) - original.col(place);
		const double distance = displacement.norm();
		if (!(distance > farthest))
			continue;
		// What rounding adds to a position stays below some last bits of its coordinates.
		const double rounding =
			8 * std::numeric_limits<double>::epsilon() * (original.col(place).norm() + farthest);
		move.col(place) += (std::max(0.0, farthest - rounding) / distance - 1) * displacement;
	}
}

NewtonRun::NewtonRun(const NewtonProblem& problem, const Positions& start, int maxIterations,
					 const Progress& progress)
	: problem_(problem), progress_(progress), maxIterations_(maxIterations), start_(start), lastNear_(start) {
	moveTo(problem.shapeAt(start));
	startCurvature_ = shape_.curvature;
}

bool NewtonRun::takeStep() {
	return !problem_.budget().spent() && takeCheapStep();
}

bool NewtonRun::takeCheapStep() {
	if (iterations_ >= maxIterations_ || problem_.budget().extraSpent())
		return false;
	++iterations_;
	return true;
}

/// Most curvature goes in the last few steps, so at first their number tells more. It never tells that a run
/// is about to end.
double NewtonRun::shareDone() const {
	constexpr double usualSteps = 12, mostBySteps = 0.9;
	return std::max(mostBySteps * (1 - std::exp(-iterations_ / usualSteps)),
					problem_.goal().shareRemoved(startCurvature_, shape_.curvature));
}

bool NewtonRun::mayGoOn() const {
	return developable::mayGoOn(progress_, shareDone(),
								describeCurvature(startCurvature_, shape_.curvature, iterations_));
}

std::optional<Shape> NewtonRun::ahead(Positions move, double farthest) const {
	pullBack(problem_.assembly().originalPositions, shape_.positions, move, farthest);
	if (!problem_.soundness().spare(shape_.positions, move))
		return {};
	Shape next = problem_.shapeAt(shape_.positions + move);
	if (!(next.farthest <= farthest))
		return {};
	return next;
}

double NewtonRun::descend(const Positions& direction, const Merit& merit, double slope, int halvings,
						  double farthest) {
	const double before = merit(shape_);
	double length = 1;
	for (int halving = 0; halving <= halvings; ++halving, length /= 2) {
		std::optional<Shape> next = ahead(length * direction, farthest);
		if (next && descendsEnough(before, slope, length, merit(*next))) {
			moveTo(std::move(*next));
			return length;
		}
	}
	return 0;
}

/// The slope is -2 |g|² but for the damping; half of it asks for no more than that leaves.
double NewtonRun::descendDefects(const Positions& direction, int halvings, double farthest) {
	const auto squaredDefects = [](const Shape& shape) { return shape.squaredDefects(); };
	return descend(direction, squaredDefects, -squaredDefects(shape_), halvings, farthest);
}

void NewtonRun::takeChords(const std::function<Positions()>& next, double farthest) {
	const NewtonTuning& tuning = problem_.tuning();
	for (int chord = 1; chord < tuning.chords && !shape_.reached; ++chord) {
		const double before = shape_.squaredDefects();
		const Positions whole = next();
		if (whole.size() == 0 || descendDefects(whole, 0, farthest) == 0 ||
			shape_.squaredDefects() > tuning.chordShare * before)
			return;
	}
}

void NewtonRun::moveTo(Shape shape) {
	shape_ = std::move(shape);
	if (isNear())
		lastNear_ = shape_.positions;
}

} // namespace developable::detail
