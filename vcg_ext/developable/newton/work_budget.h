// SPDX-License-Identifier: GPL-3.0-or-later
// work_budget.h: how much work a verdict may take, counted and not timed, so that it is the same on every
// run.
#pragma once

#include <limits>

namespace developable::detail {

/// The unit is what one product with J W⁻¹ Jᵀ takes for one place.
class WorkBudget {
public:
	explicit WorkBudget(double units = std::numeric_limits<double>::infinity()) : units_(units) {}

	void spend(double units) { used_ += units; }
	bool spent() const { return used_ >= units_; }
	double used() const { return used_; }
	double left() const { return units_ - used_; }

private:
	double units_, used_ = 0;
};

} // namespace developable::detail
