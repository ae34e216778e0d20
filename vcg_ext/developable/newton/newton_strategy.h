// SPDX-License-Identifier: GPL-3.0-or-later
// newton_strategy.h: which problems the constrained Newton method solves, in which order: levels, and panels
// left out.
#pragma once

#include "fine_level.h"
#include "unfairness.h"

#include <optional>

namespace developable::detail {

/// Large patches are first solved with a quarter of their vertices, in the same way. That solution's
/// displacement, carried over smoothly, brings the fine patches to where little curvature is left, and all of
/// it of short waves: steps along the normals take it away. What they can't take, a restoration may.
class NewtonStrategy {
public:
	/// \param memoryLimit  see SparseSolver
	/// \param fairness     the shape's own bending counts, too: waves that are shorter than this share of the
	///                     root of their part's area are smoothed away
	NewtonStrategy(double smoothness, double fairness, const CurvatureGoal& goal, int maxIterations,
				   double memoryLimit, const NewtonTuning& tuning);

	const CurvatureGoal& goal() const { return goal_; }
	const NewtonTuning& tuning() const { return tuning_; }

	const WorkBudget& budget() const { return *budget_; }
	/// What all work from now on is taken from; at first without limit.
	void setBudget(std::shared_ptr<WorkBudget> budget) { budget_ = std::move(budget); }

	/// \param length  see NewtonTuning::preferredLength
	void prefer(double length) { tuning_.preferredLength = length; }
	/// \param places  of the coarsest level of panels that are sewn together
	void beginWith(int places) { tuning_.coarsestTogether = places; }
	/// Whether it looks for what is near a fair shape of the original.
	bool isNearFairShape() const { return shapeSmoothness_ > 0; }
	/// It does from now on, without making what it finds fairer among developable shapes.
	void beginNearFairShape(double fairness);
	/// What has more places is not solved directly.
	void coarsenFrom(int places) { tuning_.coarsest = places; }
	/// Where panels that are sewn together can't be within that they are given up from now on.
	void giveUpBeyondPreferred() { tuning_.beyondPreferred = 0; }
	/// Other ways may lead to within how far a place had better move: from now on, runs without frozen panels
	/// included, finer levels take none back to within it but from nearly there, see
	/// NewtonTuning::beforeOthers.
	void leaveWaysBackToOthers() { leftToOthers_.waysBack = true; }

	/// From coarse to fine, all patches together.
	NewtonOutcome solve(const PatchAssembly& assembly, const Positions& start,
						const Progress& progress) const;

private:
	struct Level {
		const PatchAssembly& assembly;
		double coarseness;                 ///< edges are so many times as long as on the finest level
		std::optional<PatchAssembly> fair; ///< what the shape is to be near; the original where there is none

		const PatchAssembly& reference() const { return fair ? *fair : assembly; }
	};

	/// What other strategies do, and so this one does not.
	struct LeftToOthers {
		bool finestLevel = false; // this one is at work on a coarser one
		bool fairness = false;    // developable shapes are made fairer on a finer level, or not at all
		bool waysBack = false;    // to within how far a place had better move
	};

	Unfairness unfairnessOf(const PatchAssembly& assembly) const;
	Level levelOf(const PatchAssembly& assembly, double coarseness) const;
	/// Where coarser levels will follow, of panels that are sewn together: they would take noise for shape.
	void leaveDetail(Level& level) const;
	/// Whether that is all that is fair about what its shape is to be near.
	bool isWithoutDetail(const Level& level) const { return level.fair && !isNearFairShape(); }
	std::unique_ptr<NewtonProblem> problemOf(const Level& level, NewtonTuning tuning) const;
	/// One whose solution begins at that of a coarser level.
	std::unique_ptr<NewtonProblem> fineProblemOf(const Level& level) const;
	/// What is developable but for rounding, or nearly, needs no more than that. Stuck where it is not.
	NewtonOutcome solveNear(const Level& level, const Positions& start, const Progress& progress) const;
	NewtonOutcome solveLevel(const Level& level, const Positions& start, const Progress& progress) const;
	NewtonOutcome solveByCoarser(const Level& level, const Positions& start, const Progress& progress) const;
	/// Whether developable shapes are made fairer on this level, which is the finest that is not too dear.
	bool descends(const Level& level) const;
	/// For what is coarser than that.
	NewtonStrategy coarser(const Level& level) const;
	NewtonOutcome solveCoarsest(const Level& level, const Positions& start, const Progress& progress) const;
	/// \param steps    at most
	/// \param outcome  becomes what comes of it, where that is less curved
	void goOnToLeastSquares(NewtonProblem& problem, const Positions& from, int steps, NewtonOutcome& outcome,
							const Progress& progress) const;
	/// \param coarse  the outcome of the coarser level that the shape is from
	NewtonOutcome refine(NewtonProblem& problem, const CoarseShape& shape, const NewtonOutcome& coarse,
						 const Progress& progress) const;

	double smoothness_, shapeSmoothness_; // α, φ
	CurvatureGoal goal_;
	int maxIterations_;
	double memoryLimit_;
	NewtonTuning tuning_;
	std::shared_ptr<WorkBudget> budget_ = std::make_shared<WorkBudget>();
	LeftToOthers leftToOthers_;
};

} // namespace developable::detail
