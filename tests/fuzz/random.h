// SPDX-License-Identifier: GPL-3.0-or-later
// random.h: random choices that are the same on every machine, which the distributions of the standard
// library are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace developable::fuzz {

class Random {
public:
	explicit Random(std::uint64_t seed) : engine_(seed) {}

	/// 0 to count - 1.
	int below(int count) { return static_cast<int>(engine_() % count); }
	double between(double low, double high) {
		return low + (high - low) * std::ldexp(double(engine_() >> 11), -53);
	}
	bool chance(double probability) { return between(0, 1) < probability; }
	/// Of any order of magnitude between two powers of ten.
	double magnitude(double lowest, double highest) { return std::pow(10, between(lowest, highest)); }

	template <class Value>
	Value oneOf(std::initializer_list<Value> values) {
		return values.begin()[below(static_cast<int>(values.size()))];
	}

private:
	std::mt19937_64 engine_;
};

} // namespace developable::fuzz
