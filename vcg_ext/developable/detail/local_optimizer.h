// SPDX-License-Identifier: GPL-3.0-or-later
// local_optimizer.h: the order of visits of the local method, and the lowest state it has seen (Section 5.2).
#pragma once

#include "../assemble_patches.h"
#include "../progress.h"
#include "../report.h"
#include "indexed_heap.h"
#include "local_state.h"

#include <cstdio>

namespace developable {

struct LocalMethodOptions {
	static constexpr double meanEdge = -1;

	double angleTolerance = 1e-4; ///< √ε: stop when the largest abs(g) of a movable copy is this small, rad
	double maxDisplacement = meanEdge; ///< δ_T: largest move along the original normal, length; -1: L̄
	long maxOperations = 500000;       ///< N_max
};

struct LocalMethodReport : OptimizationReport {
	long setAside = 0; ///< vertices that could not move any more when the run ended
};

namespace detail {

class LocalOptimizer {
public:
	LocalOptimizer(const PatchAssembly& assembly, const Positions& positions,
				   const LocalMethodOptions& options)
		: assembly_(assembly), options_(options), state_(assembly, positions), heap_(assembly.copyCount()),
		  limit_(options.maxDisplacement == LocalMethodOptions::meanEdge ? meanEdgeLength(assembly)
																		 : options.maxDisplacement) {}

	LocalMethodReport run(Positions& positions, const Progress& progress) {
		if (allDevelopable())
			return report_;
		fillHeap();
		if (heap_.empty())
			throw NothingFree(
				"No vertex can move: those with an angle defect lie on seams or are held still. "
				"Hold fewer vertices still, or use the global method.");
		startValue_ = lowestValue_ = state_.detectFunction();
		const long patience = 20L * heap_.size();
		report_.status = Status::Stalled;
		while (!heap_.empty() && heap_.topKey() > options_.angleTolerance * options_.angleTolerance) {
			if (report_.iterations - lowestAt_ > patience)
				break;
			if (report_.iterations == options_.maxOperations) {
				report_.status = Status::LimitReached;
				break;
			}
			if (report_.iterations % operationsPerReport == 0 &&
				!mayGoOn(progress, fractionDone(), inWords())) {
				report_.status = Status::Stopped;
				return report_;
			}
			visit(heap_.top());
			++report_.iterations;
			rememberLowest();
		}
		returnToLowest();
		if (allDevelopable())
			report_.status = Status::Converged;
		positions = state_.positions();
		return report_;
	}

private:
	static constexpr long operationsPerReport = 4096;

	/// How high a copy was before a move.
	struct Move {
		int copy;
		double height;
	};

	bool movable(int copy) const {
		const int place = assembly_.placeOfCopy[copy];
		return assembly_.copyInterior[copy] && !assembly_.placeAssembling[place] &&
			   !assembly_.placeFixed[place] && state_.hasNormal(copy);
	}

	bool allDevelopable() const { return state_.defects().cwiseAbs().maxCoeff() <= options_.angleTolerance; }

	void rekey(int copy) { heap_.set(copy, state_.defects()[copy] * state_.defects()[copy]); }

	void fillHeap() {
		movable_.resize(assembly_.copyCount());
		for (int copy = 0; copy < assembly_.copyCount(); ++copy) {
			movable_[copy] = movable(copy);
			if (movable_[copy])
				rekey(copy);
		}
	}

	/// One update of δ by Eq. 19, taken whether or not it lowers T.
	void visit(int copy) {
		const double before = state_.height(copy);
		const double step = state_.localDetectFunction(copy) / state_.localDerivative(copy);
		const double after = std::clamp(before - step, -limit_, limit_);
		if (!std::isfinite(step) || after == before) {
			heap_.remove(copy); // until a neighbour moves
			++report_.setAside;
			return;
		}
		moves_.push_back({copy, before});
		state_.moveTo(copy, after);
		rekey(copy);
		for (const int neighbour : state_.neighbours(copy)) {
			if (!movable_[neighbour])
				continue;
			report_.setAside -= !heap_.contains(neighbour);
			rekey(neighbour);
		}
	}

	/// The way back to the lowest state is the list of moves since; at a new low it is empty.
	void rememberLowest() {
		if (!(state_.detectFunction() < lowestValue_))
			return;
		lowestValue_ = state_.detectFunction();
		lowestAt_ = report_.iterations;
		moves_.clear();
	}

	void returnToLowest() {
		for (auto move = moves_.rbegin(); move != moves_.rend(); ++move)
			state_.moveTo(move->copy, move->height);
		moves_.clear();
	}

	double fractionDone() const {
		return std::max(1 - lowestValue_ / startValue_, double(report_.iterations) / options_.maxOperations);
	}

	std::string inWords() const {
		char text[96];
		std::snprintf(text, sizeof text, "%ld operations: %.1f %% of the detect function removed",
					  report_.iterations, 100 * (1 - lowestValue_ / startValue_));
		return text;
	}

	const PatchAssembly& assembly_;
	const LocalMethodOptions& options_;
	LocalState state_;
	IndexedHeap heap_;
	double limit_;
	std::vector<char> movable_;
	std::vector<Move> moves_;
	double startValue_ = 0, lowestValue_ = 0;
	long lowestAt_ = 0;
	LocalMethodReport report_;
};

} // namespace detail
} // namespace developable
