// SPDX-License-Identifier: GPL-3.0-or-later
// border_separation.h: developable panels that overlap themselves when they are laid flat, moved apart.
#pragma once

#include "attempts.h"
#include "constrained_newton.h"
#include "flat_border.h"
#include "gauss_newton.h"

#include <optional>
#include <set>

namespace developable::detail {

/// A panel may be developable and yet cover itself when it is laid flat, most often by a sliver where its
/// border has a notch. Where two edges of a border cross, the end of one lies on the other's side; for the
/// one that lies there least deep there is a gap (see BorderGap) that has to grow to as much, or to a small
/// share of an edge. Gauss-Newton steps on |g|² and the squares of what gaps lack lead to where no border
/// crosses itself, and a restoration from there to where all is developable again. It is tried anew where
/// that brings new crossings.
class BorderSeparation {
public:
	/// \param run    at a developable shape
	/// \param bound  on displacements, length; what covers itself by much more is left as it is
	BorderSeparation(NewtonProblem& problem, NewtonRun& run, double bound);

	/// Whether any border crosses itself that is not left as it is.
	bool isNeeded() const { return !crossing_.empty(); }

	/// Of what still crosses itself when no more can be done the worst patch is left as it is, and the
	/// others are tried again without it. Ends with the run at the developable shape of which no other
	/// crosses itself. \return Reached; Stuck, where that is as it was; Unsolvable; Stopped
	Ending run();

private:
	void leaveDeepCrossings();
	/// \return Reached, at a developable shape of which none crosses; else anywhere
	Ending moveApart();
	void findCrossings();
	/// Of those that cross, the one whose gaps lack most.
	int worstPatch() const;
	/// Nothing where the edges touch rather than cross.
	std::optional<BorderGap> gapOf(const std::vector<int>& border, const FlatBorder& flat,
								   const std::array<int, 2>& crossing, const Eigen::VectorXd& angles) const;
	double wantedGap(double depth) const;
	/// \return its length as a share of the whole; 0 when none was any good
	double step();
	/// What the gaps lack, each as the system has it, at a shape; less than 0 where one has more than enough.
	Eigen::VectorXd lacks(const Positions& positions) const;
	Positions whole(const Eigen::VectorXd& lack);
	Eigen::VectorXd multipliers(const Eigen::MatrixXd& products, const Eigen::VectorXd& lack) const;
	double merit(const Shape& shape) const {
		return shape.squaredDefects() + lacks(shape.positions).cwiseMax(0).squaredNorm();
	}

	NewtonProblem& problem_;
	NewtonRun& run_;
	const double bound_, meanEdge_;
	const double gapScale_; ///< that gaps are as dear as angle defects
	const std::vector<std::vector<int>> borders_;
	GaussNewton restoring_;
	NormalSystem system_;
	const double firstEpsilon_;
	double epsilon_;
	std::vector<BorderGap> gaps_;
	std::set<int> leftAsTheyAre_; ///< patches
	std::set<int> crossing_;      ///< patches whose borders cross, of the others
};

/// Moves the panels of a developable part apart where they overlap themselves, hardly farther than they are.
/// \param outcome  becomes what overlaps itself in fewer panels, if that is found
void separateBorders(const PatchAssembly& part, const ConstrainedNewtonOptions& options,
					 const CurvatureGoal& goal, NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
