// SPDX-License-Identifier: GPL-3.0-or-later
// random.h: random choices that are the same on every machine, which the distributions of the standard
// library are not; or the choices that a fuzzer makes.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <random>

namespace developable::fuzz {

class Random {
public:
	explicit Random(std::uint64_t seed) : engine_(seed) {}
	/// Choices by eight bytes each, as long as there are any.
	Random(const std::uint8_t* bytes, std::size_t count)
		: engine_(count), bytes_(bytes), bytesEnd_(bytes + count) {}

	/// 0 to count - 1.
	int below(int count) { return static_cast<int>(next() % count); }
	double between(double low, double high) {
		return low + (high - low) * std::ldexp(double(next() >> 11), -53);
	}
	bool chance(double probability) { return between(0, 1) < probability; }
	/// Of any order of magnitude between two powers of ten.
	double magnitude(double lowest, double highest) { return std::pow(10, between(lowest, highest)); }

	template <class Value>
	Value oneOf(std::initializer_list<Value> values) {
		return values.begin()[below(static_cast<int>(values.size()))];
	}

private:
	std::uint64_t next() {
		std::uint64_t value = 0;
		if (bytesEnd_ - bytes_ < std::ptrdiff_t(sizeof value))
			return engine_();
		std::memcpy(&value, bytes_, sizeof value);
		bytes_ += sizeof value;
		return value;
	}

	std::mt19937_64 engine_;
	const std::uint8_t* bytes_ = nullptr;
	const std::uint8_t* bytesEnd_ = nullptr;
};

} // namespace developable::fuzz
