// SPDX-License-Identifier: GPL-3.0-or-later
// newton_attempt.cpp: the path and the landing.
#include "newton_attempt.h"

namespace developable::detail {

NewtonAttempt::NewtonAttempt(const PatchAssembly& assembly, const Eigen::VectorXd& smoothness, bool stiffens,
							 const CurvatureGoal& goal, const Progress& progress)
	: assembly_(assembly), goal_(goal), stiffens_(stiffens), progress_(progress),
	  metric_(assembly, smoothness), jacobian_(assembly, metric_.placeMass()), solver_(metric_, jacobian_),
	  soundness_(assembly) {
	metric_.factorize();
}

NewtonOutcome NewtonAttempt::run(const Positions& start, int maxIterations) {
	begin(start, maxIterations);
	Status status = followPath();
	if (status == Status::Stalled)
		status = land();
	return outcome(status);
}

NewtonOutcome NewtonAttempt::landFrom(const Positions& start, int maxIterations) {
	begin(start, maxIterations);
	epsilon_ = leastEpsilon_;
	return outcome(land());
}

void NewtonAttempt::begin(const Positions& start, int maxIterations) {
	maxIterations_ = maxIterations;
	diagonal_ = boxDiagonal(assembly_.originalPositions);
	lastNear_ = start;
	moveTo(stateAt(start));
	startCurvature_ = state_.curvature;
	jacobian_.linearize(start);
	epsilon_ = solver_.findGreatestResponse(state_.scaled) / 4;
	leastEpsilon_ = 4e-5 * epsilon_;
}

NewtonOutcome NewtonAttempt::outcome(Status status) const {
	if (state_.reached &&
		farthestDisplacement(assembly_, state_.positions) <= farthestShareReached * diagonal_)
		return {status, iterations_, state_.positions};
	return {state_.reached ? Status::Stalled : status, iterations_, lastNear_, 0, state_.reached};
}

NewtonAttempt::State NewtonAttempt::stateAt(const Positions& positions) const {
	const Eigen::VectorXd defects = angleDefects(assembly_, positions);
	State state{positions, jacobian_.scaled(defects), defects.cwiseAbs().sum(),
				metric_.squaredNorm(positions - assembly_.originalPositions),
				!goal_.unmetPatches(assembly_, defects).any()};
	return state;
}

void NewtonAttempt::moveTo(State state) {
	state_ = std::move(state);
	if (farthestDisplacement(assembly_, state_.positions) <= farthestShare * diagonal_)
		lastNear_ = state_.positions;
}

double NewtonAttempt::merit(const State& state, double tau) const {
	return tau * state.squaredDistance / 2 + state.scaled.squaredNorm() / (2 * epsilon_);
}

Status NewtonAttempt::followPath() {
	multipliers_ = Eigen::VectorXd::Zero(jacobian_.rowCount());
	while (!state_.reached) {
		if (iterations_ == maxIterations_)
			return Status::LimitReached;
		const double before = merit(state_, 1), distanceBefore = state_.squaredDistance;
		const double length = step(1);
		if (stopped_)
			return Status::Stopped;
		if (length == 0 || metric_.tooStiff())
			return Status::Stalled;
		// Stiffer triangles make φ larger, so that ε falls the sooner.
		const double decrease = 1 - merit(state_, 1) / before;
		const bool settled = std::abs(state_.squaredDistance - distanceBefore) < 0.05 * distanceBefore;
		if (state_.curvature < 0.03 * startCurvature_ && settled)
			return Status::Stalled;
		if ((length == 1 && decrease < 0.3) || decrease < 0.01) {
			if (epsilon_ < leastEpsilon_)
				return Status::Stalled;
			epsilon_ /= 4;
		}
	}
	return Status::Converged;
}

Status NewtonAttempt::land() {
	for (int idle = 0; !state_.reached;) {
		if (metric_.tooStiff())
			return Status::Stalled;
		if (iterations_ == maxIterations_)
			return Status::LimitReached;
		const double before = state_.scaled.squaredNorm();
		multipliers_.setZero(jacobian_.rowCount());
		const double length = step(0);
		if (stopped_)
			return Status::Stopped;
		idle = state_.scaled.squaredNorm() > 0.99 * before ? idle + 1 : 0;
		if (idle == idleLimit)
			return Status::Stalled;
		epsilon_ *= length == 1 ? 0.1 : length == 0 ? 16 : length < 0.25 ? 4 : 1;
	}
	return Status::Converged;
}

double NewtonAttempt::step(double tau) {
	++iterations_;
	jacobian_.linearize(state_.positions);
	Positions direction = findDirection(tau);
	for (int i = 0; stiffens_ && i < BendingMetric::stiffenings && !stopped_ && stiffen(direction); ++i)
		direction = findDirection(tau);
	return stopped_ ? 0 : search(direction, tau);
}

Positions NewtonAttempt::findDirection(double tau) {
	const Positions displacement = state_.positions - assembly_.originalPositions;
	const Eigen::VectorXd rightHandSide = state_.scaled - tau * jacobian_.apply(displacement);
	stopped_ =
		!solver_.solve(rightHandSide, epsilon_, residualShare, multipliers_, [&] { return mayGoOnNow(); });
	if (stopped_)
		return {};
	return -tau * displacement - metric_.solve(jacobian_.applyTransposed(multipliers_));
}

bool NewtonAttempt::stiffen(const Positions& direction) {
	const std::vector<int> spoilt = soundness_.spoiltTriangles(state_.positions + direction);
	if (spoilt.empty())
		return false;
	metric_.stiffen(spoilt);
	metric_.factorize();
	state_.squaredDistance = metric_.squaredNorm(state_.positions - assembly_.originalPositions);
	return true;
}

double NewtonAttempt::search(const Positions& direction, double tau) {
	const Positions displacement = state_.positions - assembly_.originalPositions;
	const double slope = tau * metric_.apply(displacement).cwiseProduct(direction).sum() +
						 jacobian_.apply(direction).dot(state_.scaled) / epsilon_;
	const double before = merit(state_, tau);
	double length = 1;
	for (int halvings = 0; halvings < 10; ++halvings, length /= 2) {
		Positions move = length * direction;
		if (!soundness_.mend(state_.positions, move))
			continue;
		State next = stateAt(state_.positions + move);
		if (merit(next, tau) <= before + 1e-4 * length * slope && merit(next, tau) < before) {
			moveTo(std::move(next));
			return length;
		}
	}
	return 0;
}

bool NewtonAttempt::mayGoOnNow() const {
	return mayGoOn(progress_, goal_.shareRemoved(startCurvature_, state_.curvature),
				   describeCurvature(startCurvature_, state_.curvature, iterations_ - 1));
}

} // namespace developable::detail
