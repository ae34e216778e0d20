// SPDX-License-Identifier: GPL-3.0-or-later
// normal_step.h: one step along the places' normals, with its system.
#pragma once

#include "newton_problem.h"

namespace developable::detail {

/// The step s = N u along the places' normals N with the least |R (g + J N u)|² + ε ‖N u‖²_W, R being the
/// weights of the rows.
class NormalStep {
public:
	explicit NormalStep(NewtonProblem& problem) : problem_(problem) {}

	/// From a shape; triangles that the whole step would spoil are made stiffer.
	/// \param rowWeights  the diagonal of R; empty: all are 1
	/// \param epsilon     ε; where it is 0 it becomes what is right for a first step
	/// \return            whether the system could be factorised
	bool factorize(const Shape& shape, const Eigen::VectorXd& rowWeights, double& epsilon);

	/// The whole step that was factorised last.
	const Positions& whole() const { return whole_; }
	/// The derivative of ½|R g|² along it, negative.
	double slope() const { return slope_; }
	/// Another with the same factor and weights 1: a chord.
	Positions chord(const Shape& shape) const;

private:
	NewtonProblem& problem_;
	SparseMatrix along_; // R J N
	Positions normals_, whole_;
	double slope_ = 0;
};

} // namespace developable::detail
