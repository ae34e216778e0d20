// SPDX-License-Identifier: GPL-3.0-or-later
// local_steps.h: steps of the few places near which a step of all of them leaves too much curvature.
#pragma once

#include "newton_run.h"

#include <optional>

namespace developable::detail {

/// A whole step often does what it should nearly everywhere, and yet leaves more curvature
/// than there was, at a few places that it takes beyond where the derivative holds. To shorten it for these
/// would hold up all others. So it is taken, and the places near those take steps of their own from there,
/// with the others held still: nonlinear elimination (Lanzkron, Rose and Wilkes 1996, An analysis of
/// approximate nonlinear elimination), where nonlinearity is local (Cai and Li 2011, Inexact Newton methods
/// with restricted additive Schwarz based nonlinear elimination for problems with high local nonlinearity).
class LocalSteps {
public:
	/// \param farthest  how far from the original a place may go, length
	LocalSteps(const NewtonProblem& problem, double farthest) : problem_(problem), farthest_(farthest) {}

	/// Takes a whole step that leaves more than it may, and local steps after it.
	/// \param may  share of |g|² that it may leave by itself
	/// \return     1; 0 where it is not taken: it leaves less, is not sound, or local steps are of no use
	double step(NewtonRun& run, const Positions& whole, double may) const;

	/// \param ahead   where a whole step leads
	/// \param before  |g|² before that step
	/// \return        the shape after rounds of local steps; nothing where what is left is not local, or
	///                these were of no use
	std::optional<Shape> improved(Shape ahead, double before) const;

private:
	/// The rows with the most of |g|² that leave, without them, a very good step; nothing where they are
	/// many.
	std::vector<int> worstRows(const Shape& shape, double before) const;

	/// Each part round some of the rows takes steps.
	Shape afterRound(const Shape& shape, const std::vector<int>& rows) const;
	/// \param order  of elimination
	/// \param work   becomes what that took
	Positions stepsOf(const AssemblyPart& part, std::vector<int> order, const Positions& from,
					  WorkBudget& work) const;

	const NewtonProblem& problem_;
	const double farthest_;
};

} // namespace developable::detail
