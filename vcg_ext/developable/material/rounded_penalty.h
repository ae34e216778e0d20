// SPDX-License-Identifier: GPL-3.0-or-later
// rounded_penalty.h: what it costs to be beyond a bound.
#pragma once

#include <cmath>

namespace developable {

/// p of an excess c, with p'(c) = κ/2 (c + √(c² + δ²)): the quadratic penalty κ/2 c₊² whose edge is rounded
/// over the width δ, so that Newton's method sees a bound coming. Convex.
struct RoundedPenalty {
	double stiffness = 1; ///< κ
	double width = 1e-3;  ///< δ, in the unit of c

	double value(double c) const { return Sum(*this).add(c).value(); }
	double first(double c) const { return stiffness / 2 * (c + root(c)); }
	double second(double c) const { return stiffness / 2 * (1 + c / root(c)); }

	/// Of several excesses, up to a dozen, with one logarithm for all.
	class Sum {
	public:
		explicit Sum(const RoundedPenalty& penalty) : penalty_(penalty) {}

		Sum& add(double c) {
			const double rounded = penalty_.root(c);
			squares_ += c * (c + rounded);
			const double factor =
				(std::abs(c) + rounded) / penalty_.width; // e to the power of |arsinh c / δ|
			product_ = c < 0 ? product_ / factor : product_ * factor;
			return *this;
		}
		double value() const {
			return penalty_.stiffness / 4 * (squares_ + penalty_.width * penalty_.width * std::log(product_));
		}

	private:
		const RoundedPenalty& penalty_;
		double squares_ = 0, product_ = 1;
	};

private:
	double root(double c) const { return std::sqrt(c * c + width * width); }
};

} // namespace developable
