// SPDX-License-Identifier: GPL-3.0-or-later
// wide.h: computing with several numbers at once, in the processor's wider registers where it has them.
#pragma once

#include <Eigen/Core>
#include <cmath>

/// What a kernel calls has to become part of it.
#define DEVELOPABLE_INLINE inline __attribute__((always_inline))
#if defined(__x86_64__)
#define DEVELOPABLE_HAS_AVX2 __builtin_cpu_supports("avx2")
#define DEVELOPABLE_AVX2 __attribute__((target("avx2")))
#else
#define DEVELOPABLE_HAS_AVX2 false
#define DEVELOPABLE_AVX2
#endif

namespace developable::detail {

/// Two and four numbers. Comparing them gives as many truths, by which `?:` chooses number by number: a
/// formula written for any Number serves these and double, with the same result to the last bit.
using TwoNumbers = double __attribute__((vector_size(16)));
using FourNumbers = double __attribute__((vector_size(32)));

/// How many numbers a Number is.
template <class Number>
constexpr int width = sizeof(Number) / sizeof(double);

/// Runs a kernel, kernel.run<Number>(), with the widest Number that the processor has registers for. Without
/// fused multiply-add, so that results are the same to the last bit on every machine.
template <class Kernel>
DEVELOPABLE_AVX2 void runWithAvx2(const Kernel kernel) {
	kernel.template run<FourNumbers>();
}
template <class Kernel>
void runWide(const Kernel kernel) {
	if (DEVELOPABLE_HAS_AVX2)
		runWithAvx2(kernel);
	else
		kernel.template run<TwoNumbers>();
}

/// Calls kernel.some<Number, groups>(first) for block after block of as many groups of Numbers, and for the
/// rest one by one. What each step does for all groups of a block the processor overlaps, since no group
/// waits for another.
template <class Number, class Kernel>
DEVELOPABLE_INLINE void inBlocks(const Kernel& kernel, int count) {
	constexpr int groups = 32 / width<Number>;
	int first = 0;
	for (; first + groups * width<Number> <= count; first += groups * width<Number>)
		kernel.template some<Number, groups>(first);
	for (; first < count; ++first)
		kernel.template some<double, 1>(first);
}

/// The numbers function(0), function(1), …
template <class Number, class Function>
DEVELOPABLE_INLINE Number gather(const Function& function) {
	if constexpr (width<Number> == 1)
		return function(0);
	else if constexpr (width<Number> == 2)
		return Number{function(0), function(1)};
	else
		return Number{function(0), function(1), function(2), function(3)};
}

/// One of the numbers.
template <class Number>
DEVELOPABLE_INLINE double at(const Number& numbers, int lane) {
	if constexpr (width<Number> == 1)
		return numbers;
	else
		return numbers[lane];
}

/// The numbers added up.
template <class Number>
DEVELOPABLE_INLINE double sum(const Number& numbers) {
	double result = 0;
	for (int lane = 0; lane < width<Number>; ++lane)
		result += at(numbers, lane);
	return result;
}

/// The pairs (a, b) of each lane. Four by way of two halves: what a compiler turns into two instructions
/// each.
template <class Number>
DEVELOPABLE_INLINE void pairs(const Number& a, const Number& b, TwoNumbers* result) {
	if constexpr (width<Number> == 4) {
		const FourNumbers even = {a[0], b[0], a[2], b[2]}, odd = {a[1], b[1], a[3], b[3]};
		result[0] = TwoNumbers{even[0], even[1]};
		result[1] = TwoNumbers{odd[0], odd[1]};
		result[2] = TwoNumbers{even[2], even[3]};
		result[3] = TwoNumbers{odd[2], odd[3]};
	} else {
		for (int lane = 0; lane < width<Number>; ++lane)
			result[lane] = TwoNumbers{at(a, lane), at(b, lane)};
	}
}

/// The same number in every lane.
template <class Number>
DEVELOPABLE_INLINE Number every(double value) {
	return Number{} + value;
}

/// The numbers without their signs.
template <class Number>
DEVELOPABLE_INLINE Number absolute(const Number& numbers) {
	if constexpr (width<Number> == 1)
		return std::abs(numbers);
	else {
		using Bits = decltype(numbers < numbers);
		return (Number)((Bits)numbers & 0x7fffffffffffffff);
	}
}

/// The same with the signs of others; none of them may be negative.
template <class Number>
DEVELOPABLE_INLINE Number withSignsOf(const Number& others, const Number& numbers) {
	if constexpr (width<Number> == 1)
		return std::copysign(numbers, others);
	else {
		using Bits = decltype(numbers < numbers);
		return (Number)((Bits)numbers | ((Bits)others & (-0x7fffffffffffffff - 1)));
	}
}

template <class Number>
DEVELOPABLE_INLINE Number squareRoot(const Number& numbers) {
	using Array = Eigen::Array<double, width<Number>, 1>;
	Array roots;
	for (int lane = 0; lane < width<Number>; ++lane)
		roots[lane] = at(numbers, lane);
	roots = roots.sqrt().eval();
	return gather<Number>([&](int lane) { return roots[lane]; });
}

} // namespace developable::detail
