// SPDX-License-Identifier: GPL-3.0-or-later
// local_optimizer.cpp: one run of the local method (Section 5.2).
#include "local_optimizer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace developable::detail {

LocalOptimizer::LocalOptimizer(const PatchAssembly& assembly, const Positions& positions,
							   const LocalMethodOptions& options)
	: options_(options), state_(assembly, positions, options.assemblingVertices), mesh_(state_.mesh()),
	  worst_(mesh_.originalPlace), lookAhead_(mesh_),
	  limit_(options.maxDisplacement == LocalMethodOptions::meanEdge ? meanEdgeLength(assembly)
																	 : options.maxDisplacement),
	  smoothing_(options.smoothing / std::pow(meanEdgeLength(assembly), 2)) {}

void LocalOptimizer::goOnFrom(const LocalOptimizer& other) {
	for (int place = 0; place < mesh_.placeCount(); ++place)
		if (other.state_.height(place) != 0)
			state_.moveTo(place, other.state_.height(place));
	report_.iterations = lowestAt_ = other.report_.iterations;
	report_.refusedMoves = other.report_.refusedMoves;
}

bool LocalOptimizer::anyMovable() const {
	for (int place = 0; place < mesh_.placeCount(); ++place)
		if (mesh_.movable(place))
			return true;
	return false;
}

LocalMethodReport LocalOptimizer::run(Positions& positions, const Progress& progress) {
	if (allDevelopable())
		return report_;
	if (options_.avoidSelfIntersections)
		intersections_.emplace(mesh_, options_.roundedToFloat);
	fillTournament();
	movableCount_ = worst_.size();
	startValue_ = lowestValue_ = state_.detectFunction();
	report_.status = visitAll(progress);
	report_.setAside = movableCount_ - worst_.size();
	if (report_.status == Status::Stopped)
		return report_;
	returnToLowest();
	if (allDevelopable()) {
		report_.status = Status::Converged;
		report_.reason = Reason::AsStatus;
	}
	positions = state_.positions();
	return report_;
}

bool LocalOptimizer::allDevelopable() const {
	return largestAngleDefect(state_.defects()) <= options_.angleTolerance;
}

void LocalOptimizer::fillTournament() {
	for (int place = 0; place < mesh_.placeCount(); ++place)
		if (mesh_.movable(place))
			rekey(place);
	if (worst_.empty())
		throw NothingFree("No vertex can move: those with an angle defect lie on seams or are held still. "
						  "Hold fewer vertices still, or use the global method.");
}

Status LocalOptimizer::visitAll(const Progress& progress) {
	constexpr long operationsPerReport = 4096;
	const long patience = 20L * movableCount_;
	while (!worst_.empty() && worst_.topKey() > options_.angleTolerance * options_.angleTolerance) {
		if (report_.iterations - lowestAt_ > patience) {
			report_.reason = Reason::NotLowered;
			return Status::Stalled;
		}
		if (report_.iterations == options_.maxOperations)
			return Status::LimitReached;
		if (report_.iterations % operationsPerReport == 0 && !mayGoOn(progress, fractionDone(), inWords()))
			return Status::Stopped;
		++report_.iterations;
		const int place = worst_.top();
		visit(place);
		rememberLowest();
		if (const int soon = worst_.successor(place); soon >= 0)
			lookAhead_.expect(soon);
	}
	report_.reason = Reason::NothingMoves;
	return Status::Stalled;
}

/// One update of δ, or none: then the place is set aside until a neighbour moves.
void LocalOptimizer::visit(int place) {
	const double before = state_.height(place);
	if (move(place, before, wantedHeight(place))) {
		moves_.push_back({place, before});
		rekeyRound(place);
	} else {
		worst_.remove(place);
	}
}

/// The height that Eq. 19 asks for, within ±δ_T.
double LocalOptimizer::wantedHeight(int place) const {
	const double step = -objective(place) / objectiveDerivative(place);
	return std::isfinite(step) ? std::clamp(state_.height(place) + step, -limit_, limit_)
							   : state_.height(place);
}

/// T (Eq. 15), and with `smoothing` the mean square difference in height to the neighbours, in edge lengths.
double LocalOptimizer::objective(int place) const {
	const double value = state_.localDetectFunction(place);
	return smoothing_ > 0 ? value + smoothing_ * state_.unevenness(place) : value;
}

double LocalOptimizer::objectiveDerivative(int place) const {
	const double derivative = state_.localDerivative(place);
	return smoothing_ > 0 ? derivative + smoothing_ * state_.unevennessDerivative(place) : derivative;
}

/// The paper takes every move; `descent` and `avoidSelfIntersections` halve it until it is acceptable.
/// \return false when the place is where it was
bool LocalOptimizer::move(int place, double before, double wanted) {
	constexpr int mostHalvings =
		10; // fewer give up too soon, more lose themselves in moves that gain nothing
	if (wanted == before)
		return false;
	const double startValue = options_.descent ? objective(place) : 0;
	bool intersected = false;
	for (int halving = 0; halving <= mostHalvings; ++halving) {
		// before + (wanted - before) may round to another height than the one wanted.
		state_.moveTo(place, halving == 0 ? wanted : before + std::ldexp(wanted - before, -halving));
		const bool descended = !options_.descent || objective(place) < startValue;
		const bool intersects = descended && intersections_ && intersections_->newOnes(place);
		if (descended && !intersects)
			return true;
		intersected |= intersects;
	}
	state_.moveTo(place, before);
	report_.refusedMoves += intersected;
	return false;
}

/// The place with the largest g² comes first. Where patches meet g may be 0 in each of them though a move
/// would help the neighbours: there the largest g² among the terms of T counts.
void LocalOptimizer::rekey(int place) {
	const int first = mesh_.places[place].firstCopy;
	worst_.set(place,
			   mesh_.copies[first].alone ? state_.squaredDefect(first) : state_.largestSquaredDefect(place));
}

void LocalOptimizer::rekeyRound(int place) {
	mesh_.forEachAffected(place, [&](int copy) {
		if (mesh_.copies[copy].movable)
			rekey(mesh_.copies[copy].place);
		if (mesh_.copies[copy].watched)
			for (const int watcher : mesh_.watchers.at(copy))
				rekey(watcher);
	});
}

/// The way back to the lowest state is the list of moves since; at a new low it is empty.
void LocalOptimizer::rememberLowest() {
	if (!(state_.detectFunction() < lowestValue_))
		return;
	lowestValue_ = state_.detectFunction();
	lowestAt_ = report_.iterations;
	moves_.clear();
}

void LocalOptimizer::returnToLowest() {
	for (auto move = moves_.rbegin(); move != moves_.rend(); ++move)
		state_.moveTo(move->place, move->height);
	moves_.clear();
}

double LocalOptimizer::fractionDone() const {
	return std::max(1 - lowestValue_ / startValue_, double(report_.iterations) / options_.maxOperations);
}

std::string LocalOptimizer::inWords() const {
	char text[96];
	std::snprintf(text, sizeof text, "%ld operations: %.1f %% of the detect function removed",
				  report_.iterations, 100 * (1 - lowestValue_ / startValue_));
	return text;
}

} // namespace developable::detail
