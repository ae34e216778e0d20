// SPDX-License-Identifier: GPL-3.0-or-later
// normal_steps.cpp: steps along the normals, with chords.
#include "normal_steps.h"

namespace developable::detail {

NewtonOutcome NormalSteps::run(const Positions& start, double farthest, int maxIterations) {
	NewtonOutcome outcome;
	farthest_ = farthest;
	moveTo(start);
	startCurvature_ = defects_.cwiseAbs().sum();
	outcome.status = iterate(maxIterations);
	outcome.iterations = iterations_;
	outcome.positions = positions_;
	return outcome;
}

Status NormalSteps::iterate(int maxIterations) {
	for (int idle = 0; !reached_;) {
		if (!mayGoOnNow())
			return Status::Stopped;
		if (iterations_ == maxIterations)
			return Status::LimitReached;
		++iterations_;
		const double before = scaled_.squaredNorm();
		const double length = factorize() ? stepsWithOneFactorization() : 0;
		const double share = scaled_.squaredNorm() / before;
		idle = share > 0.98 ? idle + 1 : 0;
		if (idle == idleLimit)
			return Status::Stalled;
		epsilon_ *= epsilonFactor(share, length);
	}
	return Status::Converged;
}

double NormalSteps::epsilonFactor(double shareLeft, double length) {
	if (shareLeft < 0.5)
		return shareLeft < 0.1 ? 0.1 : 0.3;
	if (length == 0)
		return 16;
	return length == 1 ? 0.5 : length < 0.3 ? 4 : 1;
}

void NormalSteps::moveTo(const Positions& positions) {
	positions_ = positions;
	defects_ = angleDefects(assembly_, positions);
	scaled_ = jacobian_.scaled(defects_);
	reached_ = !goal_.unmetPatches(assembly_, defects_).any();
}

bool NormalSteps::factorize() {
	jacobian_.linearize(positions_);
	normals_ = placeNormals(assembly_, positions_);
	along_ = jacobian_.along(normals_);
	if (epsilon_ == 0) // normals are one long, so W and NᵀWN have the same trace
		epsilon_ = firstShare * along_.squaredNorm() / metric_.matrix().diagonal().sum();
	for (int i = 0; solver_.factorize(system_.fill(along_, normals_, epsilon_)); ++i) {
		firstStep_ = wholeStep();
		if (i == BendingMetric::stiffenings || !stiffen())
			return true;
	}
	return false;
}

bool NormalSteps::stiffen() {
	if (metric_.tooStiff())
		return false;
	const std::vector<int> spoilt = soundness_.spoiltTriangles(positions_ + firstStep_);
	metric_.stiffen(spoilt);
	return !spoilt.empty();
}

Positions NormalSteps::wholeStep() const {
	return normals_ * solver_.solve(Eigen::VectorXd(-(along_.transpose() * scaled_))).asDiagonal();
}

double NormalSteps::stepsWithOneFactorization() {
	const double length = tryStep(firstStep_, 8);
	for (int chord = 1; chord < chordLimit && length > 0 && !reached_ && mayGoOnNow(); ++chord) {
		const double before = scaled_.squaredNorm();
		if (tryStep(wholeStep(), 1) == 0 || scaled_.squaredNorm() > 0.5 * before)
			break;
	}
	return length;
}

double NormalSteps::tryStep(const Positions& whole, int lengths) {
	const double before = scaled_.squaredNorm();
	double length = 1;
	for (int i = 0; i < lengths; ++i, length /= 2) {
		Positions move = length * whole;
		if (!soundness_.mend(positions_, move))
			continue;
		const Positions candidate = positions_ + move;
		if (farthestDisplacement(assembly_, candidate) > farthest_ ||
			!(jacobian_.scaled(angleDefects(assembly_, candidate)).squaredNorm() <
			  (1 - 1e-4 * length) * before))
			continue;
		moveTo(candidate);
		return length;
	}
	return 0;
}

bool NormalSteps::mayGoOnNow() const {
	const double left = defects_.cwiseAbs().sum();
	return mayGoOn(progress_, goal_.shareRemoved(startCurvature_, left),
				   describeCurvature(startCurvature_, left, iterations_));
}

} // namespace developable::detail
