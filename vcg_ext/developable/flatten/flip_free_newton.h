// SPDX-License-Identifier: GPL-3.0-or-later
// flip_free_newton.h: Newton's method on the springs of a flat panel, in steps that flip no triangle.
#pragma once

#include "hessian_solver.h"
#include "plane_springs.h"

namespace developable::detail {

/// How a minimisation ended.
struct FlatMinimum {
	bool converged = false;
	bool stopped = false; ///< by the user
	int iterations = 0;
};

/// Minimises the energy of springs from a layout without flips to one without flips.
class FlipFreeNewton {
public:
	/// \param positions  where it begins, and where the result goes
	FlipFreeNewton(PlaneSprings& springs, PlanePositions& positions)
		: springs_(springs), positions_(positions), hessian_(springs.hessianPattern()),
		  isometricEnergy_(1e-23 * springs.scale()) {}

	/// \param iterations  at most
	FlatMinimum minimize(int iterations, const Progress& progress);

	/// From the minimum goes on to a layout near it whose mean edge strain is some per cent less, for an
	/// energy that is some tenths of a per cent more. The least sum of squares spreads strain over many
	/// edges.
	void lessenMeanStrain();

private:
	static constexpr double shareOfMeanStrain = 0.15;

	void setBarrier(double guardedShare);

	/// \return  by how much the energy went down, as far as the quadratic model could tell
	double step();

	/// The Newton direction; near the minimum with the exact second derivatives where these are definite.
	PlanePositions descent(const PlanePositions& gradient);

	PlaneSprings& springs_;
	PlanePositions& positions_;
	PlaneHessian hessian_;
	HessianSolver solver_;
	double isometricEnergy_; // below which only rounding is left
	double energy_ = 0;
	bool exact_ = false;
};

} // namespace developable::detail
