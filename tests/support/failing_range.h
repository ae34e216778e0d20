// SPDX-License-Identifier: GPL-3.0-or-later
// failing_range.h: which of many calls fail, by their numbers. It allocates nothing.
#pragma once

#include <atomic>
#include <cerrno>

namespace developable::test {

/// Counts calls, on all threads, from begin() to end().
class FailingRange {
public:
	/// \param first  the number of the first that fails, from 1; 0: none does
	/// \param count  how many fail
	void set(long first, long count) {
		first_ = first;
		last_ = first > 0 ? first - 1 + count : -1;
	}

	void begin() { number_ = 0; }
	/// \return how many calls there were
	long end() { return number_.exchange(never); }

	/// \return the number of this call, from 1; 0 while none are counted
	long next() { return number_.load(std::memory_order_relaxed) == never ? 0 : ++number_; }

	/// Whether the call with a number fails; errno says so then.
	bool fails(long number) const {
		const bool result = number > 0 && number >= first_ && number <= last_;
		if (result)
			errno = ENOMEM;
		return result;
	}

private:
	static constexpr long never = -1;

	std::atomic<long> number_ = never; ///< of the last call
	std::atomic<long> first_ = 0, last_ = -1;
};

} // namespace developable::test
