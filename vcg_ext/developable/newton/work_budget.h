// SPDX-License-Identifier: GPL-3.0-or-later
// work_budget.h: how much work a verdict may take, counted and not timed, so that it is the same on every
// run.
#pragma once

#include <limits>

namespace developable::detail {

/// The unit is what one product with J W⁻¹ Jᵀ takes for one place.
class WorkBudget {
public:
	explicit WorkBudget(double units = std::numeric_limits<double>::infinity()) : left_(units) {}

	void spend(double units) { left_ -= units; }
	bool spent() const { return left_ <= 0; }

private:
	double left_;
};

} // namespace developable::detail
