// SPDX-License-Identifier: GPL-3.0-or-later
// penalty_function.h: what the global method minimises (Section 4.1).
#pragma once

#include "developable/mesh/mesh.h"

namespace developable::detail {

/// J = E + ρ/2 · G² (Eq. 9) with its gradient (Eq. 10), as a function of the places' positions.
class PenaltyFunction {
public:
	/// \param assembly  must outlive this
	explicit PenaltyFunction(const PatchAssembly& assembly);

	/// Chooses ρ for the outer step that starts at this value of G: Σ l0² / (n_e · G²).
	void weighFor(double detectFunctionAtStart);

	double value(const Positions& positions) const;

	/// 3 x places; 0 where a place is held still.
	Positions gradient(const Positions& positions) const;

private:
	const PatchAssembly& assembly_;
	Eigen::VectorXd originalLengths_;
	double penalty_ = 0;
};

} // namespace developable::detail
