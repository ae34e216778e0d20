// SPDX-License-Identifier: GPL-3.0-or-later
// fan_kernel.h: the angle defects of all vertex copies from their cotangents, fast.
#pragma once

#include "angle_sum.h"

#include <algorithm>

namespace developable::detail {

/// 2π minus the angles at every copy, inside its patch and on its boundary.
struct FanKernel {
	const double* cotangents; ///< of all corners
	const int* corners;       ///< those of each copy
	const int* cornerStart;   ///< copies + 1
	int copies;
	double* defects; ///< out, per copy

	template <class Number>
	DEVELOPABLE_INLINE void run() const {
		inBlocks<Number>(*this, copies);
	}

	/// First the products of all groups, then their arguments.
	template <class Number, int groups>
	DEVELOPABLE_INLINE void some(int first) const {
		FanProduct<Number> products[groups];
		for (int group = 0; group < groups; ++group)
			products[group] = product<Number>(first + group * width<Number>);
		Number total{};
		for (int group = 0; group < groups; ++group) {
			const Number results = products[group].defect();
			total += results;
			for (int lane = 0; lane < width<Number>; ++lane)
				defects[first + group * width<Number> + lane] = at(results, lane);
		}
		// Products of thin triangles may have grown beyond all numbers.
		if (std::isnan(sum(total)))
			for (int copy = first; copy < first + groups * width<Number>; ++copy)
				defects[copy] = one(copy);
	}

private:
	template <class Number>
	DEVELOPABLE_INLINE FanProduct<Number> product(int first) const {
		int least = degree(first), most = least;
		for (int lane = 1; lane < width<Number>; ++lane) {
			least = std::min(least, degree(first + lane));
			most = std::max(most, degree(first + lane));
		}
		const Number degrees =
			gather<Number>([&](int lane) { return static_cast<double>(degree(first + lane)); });
		const Number one = every<Number>(1), zero{};
		FanProduct<Number> product;
		for (int step = 0; step < least; ++step)
			product.add(gather<Number>(
							[&](int lane) { return cotangents[corners[cornerStart[first + lane] + step]]; }),
						one);
		for (int step = least; step < most; ++step) {
			const Number cotangent = gather<Number>([&](int lane) {
				return cotangents[corners[std::min(cornerStart[first + lane] + step,
												   cornerStart[first + lane + 1] - 1)]];
			});
			const auto within = every<Number>(step) < degrees;
			product.add(within ? cotangent : one, within ? one : zero);
		}
		return product;
	}

	DEVELOPABLE_INLINE int degree(int copy) const { return cornerStart[copy + 1] - cornerStart[copy]; }

	double one(int copy) const {
		AngleSum sum;
		for (int i = cornerStart[copy]; i < cornerStart[copy + 1]; ++i)
			sum.add(cotangents[corners[i]]);
		return sum.defect();
	}
};

} // namespace developable::detail
