// SPDX-License-Identifier: GPL-3.0-or-later
// local_optimizer.h: the order of visits of the local method, and the lowest state it has seen (Section 5.2).
#pragma once

#include "local_method.h"
#include "local_state.h"
#include "look_ahead.h"
#include "self_intersections.h"
#include "tournament.h"

#include <optional>
#include <string>
#include <vector>

namespace developable::detail {

/// One run: visits the worst place and moves it, until none is bad or none can move.
class LocalOptimizer {
public:
	/// \param options  must outlive this
	LocalOptimizer(const PatchAssembly& assembly, const Positions& positions,
				   const LocalMethodOptions& options);

	/// Begins at the state that another run has left, with its operations counted.
	void goOnFrom(const LocalOptimizer& other);

	/// \return  what localMethod returns; the positions are as it leaves them
	LocalMethodReport run(Positions& positions, const Progress& progress);

	/// Whether any place may move.
	bool anyMovable() const;

private:
	/// How high a place was before a move.
	struct Move {
		int place;
		double height;
	};

	bool allDevelopable() const;
	void fillTournament();

	Status visitAll(const Progress& progress);
	void visit(int place);
	double wantedHeight(int place) const;
	double objective(int place) const;
	double objectiveDerivative(int place) const;
	bool move(int place, double before, double wanted);
	void rekey(int place);
	void rekeyRound(int place);

	void rememberLowest();
	void returnToLowest();

	double fractionDone() const;
	std::string inWords() const;

	const LocalMethodOptions& options_;
	LocalState state_;
	const LocalMesh& mesh_;
	Tournament worst_;
	LookAhead lookAhead_;
	int movableCount_ = 0;
	double limit_;
	double smoothing_;                               // rad² / length²
	std::optional<SelfIntersections> intersections_; // where they are to be avoided
	std::vector<Move> moves_;
	double startValue_ = 0, lowestValue_ = 0;
	long lowestAt_ = 0;
	LocalMethodReport report_;
};

} // namespace developable::detail
