// SPDX-License-Identifier: GPL-3.0-or-later
// work_budget.h: how much work a verdict may take, counted and not timed, so that it is the same on every
// run.
#pragma once

#include <algorithm>
#include <limits>

namespace developable::detail {

/// The unit is what one product with J W⁻¹ Jᵀ takes for one place, about a third of a microsecond.
class WorkBudget {
public:
	explicit WorkBudget(double units = std::numeric_limits<double>::infinity()) : units_(units) {}

	void spend(double units) { used_ += units; }
	/// As much as such a factorisation takes.
	/// \param operations  multiplications and additions, see SparseCholesky
	void spendOperations(double operations) { used_ += operations / operationsPerUnit; }
	bool spent() const { return used_ + reserved_ >= units_; }
	double used() const { return used_; }
	double left() const { return units_ - used_ - reserved_; }

private:
	friend class WorkReserve;
	static constexpr double operationsPerUnit = 3500; ///< in dense blocks

	double units_, used_ = 0, reserved_ = 0;
};

/// While it lasts, a share of what is left is kept for what comes after.
class WorkReserve {
public:
	WorkReserve(WorkBudget& budget, double share) : budget_(budget), before_(budget.reserved_) {
		if (budget.left() < std::numeric_limits<double>::infinity())
			budget.reserved_ += share * std::max(0.0, budget.left());
	}
	~WorkReserve() { budget_.reserved_ = before_; }
	WorkReserve(const WorkReserve&) = delete;
	WorkReserve& operator=(const WorkReserve&) = delete;

private:
	WorkBudget& budget_;
	const double before_;
};

} // namespace developable::detail
