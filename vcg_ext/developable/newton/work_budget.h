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
	/// \param extra  of the units, see ExtraWork
	explicit WorkBudget(double units = std::numeric_limits<double>::infinity(),
						double extra = std::numeric_limits<double>::infinity())
		: units_(units), extraUnits_(extra) {}

	void spend(double units) {
		used_ += units;
		extra_ += isExtra_ ? units : 0;
	}
	/// As much as such a factorisation takes.
	/// \param operations  multiplications and additions, see SparseCholesky
	void spendOperations(double operations) { spend(operations / operationsPerUnit); }
	/// What has been spent of another.
	void spend(const WorkBudget& other) {
		used_ += other.used_;
		extra_ += other.extra_;
	}
	bool spent() const { return used_ + reserved_ >= units_ || extraSpent(); }
	/// Whether that is what is being worked on.
	bool extraSpent() const { return isExtra_ && extra_ >= extraEnd_; }
	double used() const { return used_; }
	double left() const { return units_ - used_ - reserved_; }
	/// Of what is used, and of what is left.
	double extraUsed() const { return extra_; }
	double extraLeft() const { return extraUnits_ - extra_; }
	double usedForTheRest() const { return used_ - extra_; }

private:
	friend class WorkReserve;
	friend class ExtraWork;
	static constexpr double operationsPerUnit = 3500; ///< in dense blocks

	double units_, extraUnits_, used_ = 0, reserved_ = 0, extra_ = 0;
	double extraEnd_ = 0; ///< of extra_
	bool isExtra_ = false;
};

/// While it lasts, a share of what is left is kept for what comes after.
class WorkReserve {
public:
	WorkReserve(WorkBudget& budget, double share) : budget_(budget), before_(budget.reserved_) {
		if (budget.left() < std::numeric_limits<double>::infinity())
			budget.reserved_ += share * std::max(0.0, budget.left());
	}
	~WorkReserve() { release(); }
	/// Ends it sooner.
	void release() { budget_.reserved_ = before_; }
	WorkReserve(const WorkReserve&) = delete;
	WorkReserve& operator=(const WorkReserve&) = delete;

private:
	WorkBudget& budget_;
	const double before_;
};

/// What is spent while it lasts is extra, for what is only preferred. All that is extra may be so many times
/// the rest, and no more than the budget has for it; where it is, the budget is spent until this ends.
class ExtraWork {
public:
	/// \param times  the rest
	/// \param begin  the budget as it was where the rest begins
	ExtraWork(WorkBudget& budget, double times, const WorkBudget& begin = WorkBudget())
		: budget_(budget), endBefore_(budget.extraEnd_), wasExtra_(budget.isExtra_) {
		const double rest = budget.usedForTheRest() - begin.usedForTheRest();
		budget.extraEnd_ = std::min(begin.extra_ + times * rest, budget.extraUnits_);
		if (wasExtra_)
			budget.extraEnd_ = std::min(budget.extraEnd_, endBefore_);
		budget.isExtra_ = true;
	}
	~ExtraWork() {
		budget_.extraEnd_ = endBefore_;
		budget_.isExtra_ = wasExtra_;
	}
	ExtraWork(const ExtraWork&) = delete;
	ExtraWork& operator=(const ExtraWork&) = delete;

private:
	WorkBudget& budget_;
	const double endBefore_;
	const bool wasExtra_;
};

} // namespace developable::detail
