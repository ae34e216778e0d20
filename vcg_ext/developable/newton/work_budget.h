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
	/// What has been spent of another.
	void spend(const WorkBudget& other) {
		used_ += other.used_;
		extra_ += other.extra_;
	}
	bool spent() const { return used_ + reserved_ >= units_ || used_ >= extraEnd_; }
	double used() const { return used_; }
	double left() const { return units_ - used_ - reserved_; }

private:
	friend class WorkReserve;
	friend class ExtraWork;
	static constexpr double operationsPerUnit = 3500; ///< in dense blocks

	double units_, used_ = 0, reserved_ = 0;
	double extra_ = 0; ///< of what is used
	double extraEnd_ = std::numeric_limits<double>::infinity();
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

/// What is spent while it lasts is extra, for what is only preferred. All that is extra may be so many times
/// the rest; where it is, the budget is spent until this ends.
class ExtraWork {
public:
	/// \param times  the rest
	/// \param begin  the budget as it was where the rest begins
	ExtraWork(WorkBudget& budget, double times, const WorkBudget& begin = WorkBudget())
		: budget_(budget), before_(budget.used_), extraBefore_(budget.extra_), endBefore_(budget.extraEnd_) {
		const double extra = budget.extra_ - begin.extra_, rest = budget.used_ - begin.used_ - extra;
		budget.extraEnd_ = std::min(endBefore_, before_ + times * rest - extra);
	}
	~ExtraWork() {
		budget_.extra_ = extraBefore_ + budget_.used_ - before_;
		budget_.extraEnd_ = endBefore_;
	}
	ExtraWork(const ExtraWork&) = delete;
	ExtraWork& operator=(const ExtraWork&) = delete;

private:
	WorkBudget& budget_;
	const double before_, extraBefore_, endBefore_;
};

} // namespace developable::detail
