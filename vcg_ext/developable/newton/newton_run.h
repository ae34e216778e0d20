// SPDX-License-Identifier: GPL-3.0-or-later
// newton_run.h: one run of steps: where it is, how far it may go, and how every step is guarded.
#pragma once

#include "developable/descent/descent.h"
#include "newton_problem.h"

#include <functional>
#include <optional>

namespace developable::detail {

/// How the steps of one kind ended.
enum class Ending {
	Reached,    ///< every patch is developable
	Settled,    ///< next to nothing of the curvature is left, and the distance has settled
	Stuck,      ///< steps make no difference any more
	TooFar,     ///< farther away than is of any use, before it was developable
	Unsolvable, ///< a linear system has no solution in double precision
	OutOfSteps,
	Stopped ///< by the user
};

/// Shortens a move such that no place ends farther from where it was originally.
void pullBack(const Positions& original, const Positions& from, Positions& move, double farthest);

/// A shape on its way to g = 0, with the number of steps that it has taken and may take.
class NewtonRun {
public:
	NewtonRun(const NewtonProblem& problem, const Positions& start, int maxIterations,
			  const Progress& progress);

	/// Another, of the same problem.
	NewtonRun elsewhere(const Positions& start, int maxIterations) const {
		return {problem_, start, maxIterations, progress_};
	}

	const Shape& shape() const { return shape_; }
	int iterations() const { return iterations_; }
	double startCurvature() const { return startCurvature_; }

	/// Back to where it began; steps are counted on.
	void restart() { moveTo(problem_.shapeAt(start_)); }
	/// Back to a shape that it has had.
	void goBackTo(const Shape& shape) { moveTo(shape); }

	/// Counts a step. \return false when there have been as many as may be, or the work is spent
	bool takeStep();
	/// The same for a step that costs little: it is not taken from the budget of work, but where it is extra.
	bool takeCheapStep();

	/// Tells how far the run is. \return false when the user asks for a stop
	bool mayGoOn() const;

	/// What a step has to lower: of a shape, any unit.
	using Merit = std::function<double(const Shape&)>;

	/// Where a move would lead: triangles that it would spoil move as one piece, and places that would go too
	/// far are pulled back. Nothing where that is not sound.
	/// \param farthest  that a place may be from where it was, length
	std::optional<Shape> ahead(Positions move, double farthest) const;

	/// The one guarded descent of all steps: goes along a direction, all the way or half of it, a quarter
	/// and so on, to what is ahead there if its merit is lower enough (see descendsEnough).
	///
	/// \param slope      of the merit along the direction, negative
	/// \param farthest   see ahead
	/// \return           how much of the direction it went; 0 when nothing was any good, and the shape is
	///                   the same
	double descend(const Positions& direction, const Merit& merit, double slope, int halvings,
				   double farthest = std::numeric_limits<double>::infinity());

	/// The same towards g = 0, from the slope that |g|² has along a Newton step.
	double descendDefects(const Positions& direction, int halvings, double farthest);

	/// Chords, after a whole step whose system was factorised: further whole ones with its factor, each
	/// towards what g is by then, as long as each removes enough.
	/// \param next      from where the run is; empty when there is no other, or the user asks for a stop
	/// \param farthest  see ahead
	void takeChords(const std::function<Positions()>& next, double farthest);

	/// The last shape that was within the bound on displacements; at first the start, even if that is not.
	const Positions& nearest() const { return lastNear_; }

	/// It led to a developable shape, but farther away than places may go.
	bool farOff() const { return shape_.reached && !isNear(); }

private:
	/// Of the run, as far as one can tell, 0 to 1.
	double shareDone() const;
	bool isNear() const { return shape_.farthest <= problem_.goal().farthest; }
	void moveTo(Shape shape);

	const NewtonProblem& problem_;
	const Progress& progress_;
	const int maxIterations_;
	int iterations_ = 0;
	Shape shape_;
	const Positions start_;
	Positions lastNear_;
	double startCurvature_ = 0;
};

} // namespace developable::detail
