// SPDX-License-Identifier: GPL-3.0-or-later
// border_separation.h: developable panels that overlap themselves when they are laid flat, moved apart.
#pragma once

#include "attempts.h"
#include "constrained_newton.h"
#include "flat_border.h"
#include "gauss_newton.h"

#include <set>

namespace developable::detail {

/// A panel may be developable and yet cover itself when it is laid flat, most often by a sliver where its
/// border has a notch. Where two edges of a border cross, the end of one lies on the other's side; for the
/// one that lies there least deep there is a gap (see BorderGap) that has to grow to a small share of an
/// edge. Gauss-Newton steps on |g|² and the squares of what gaps lack lead to where no border crosses itself,
/// and a restoration from there to where all is developable again. It is tried anew where that brings new
/// crossings.
class BorderSeparation {
public:
	/// \param run    at a developable shape
	/// \param bound  on displacements, length; what covers itself by much more is left as it is
	BorderSeparation(NewtonProblem& problem, NewtonRun& run, double bound);

	/// Whether any border crosses itself that is not left as it is.
	bool isNeeded() const { return crossing_ > 0; }

	/// Ends with the run at the developable shape with fewest patches whose borders cross.
	/// \return Reached, where that is none; Stuck; Unsolvable; Stopped
	Ending run();

private:
	void leaveDeepCrossings();
	void findCrossings();
	BorderGap gapOf(const std::vector<int>& border, const FlatBorder& flat,
					const std::array<int, 2>& crossing, const Eigen::VectorXd& angles) const;
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
	double epsilon_;
	std::vector<BorderGap> gaps_;
	std::set<int> leftAsTheyAre_; ///< patches
	int crossing_ = 0;            ///< patches whose borders cross
};

/// Moves the panels of a developable part apart where they overlap themselves, hardly farther than they are.
/// \param outcome  becomes what overlaps itself in fewer panels, if that is found
void separateBorders(const PatchAssembly& part, const ConstrainedNewtonOptions& options,
					 const CurvatureGoal& goal, NewtonOutcome& outcome, const Progress& progress);

} // namespace developable::detail
