// SPDX-License-Identifier: GPL-3.0-or-later
// hardening.h: how bounds become hard, from a soft elastic sheet to one that gives way to a point and no
// further.
#pragma once

#include "strain_penalty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable {

/// Whether bounds can't be kept. Where they can, violations fall nearly as the stiffness grows; else they
/// come to an end. \param violations  before each hardening, the greatest of them
inline bool hopeless(const std::vector<double>& violations) {
	constexpr std::size_t hardenings = 4; // 256 times the stiffness
	constexpr double share = 0.7;         // of the violation so many before
	return violations.size() > hardenings &&
		   violations.back() > share * violations[violations.size() - 1 - hardenings];
}

/// The row of stiffnesses κ, each with the width δ ~ κ^−0.6 of the bounds' edges: so that κ δ², what the
/// rounding costs, falls too.
class Hardening {
public:
	explicit Hardening(StrainPenalty& penalty, double first = 0.1)
		: penalty_(penalty), first_(first), stiffness_(first) {
		apply();
	}

	/// \return false when it is as hard as it gets
	bool harden() {
		if (stiffness_ >= hardest)
			return false;
		stiffness_ *= factor;
		apply();
		return true;
	}

	/// Narrower edges of bounds that are as hard already.
	void sharpen() {
		sharpness_ *= 2;
		apply();
	}

	/// After a step that was no good: bounds that were hardened too soon.
	void soften() {
		stiffness_ = std::max(stiffness_ / (factor * factor), first_);
		sharpness_ = std::max(sharpness_ / (factor * factor), 1.0);
		apply();
	}

	/// κ δ²: by how much the cost of the best shape may be above its least as bounds are felt before they are
	/// reached. For c ≪ −δ the slope of p is κ δ² / (4 |c|), that of a logarithmic barrier, and each triangle
	/// has four bounds.
	double costOfRounding() const { return stiffness_ * penalty_.edge().width * penalty_.edge().width; }

private:
	static constexpr double hardest = 1e7, factor = 4, softWidth = 0.02;

	void apply() { penalty_.harden(stiffness_, softWidth * std::pow(0.1 / stiffness_, 0.6) / sharpness_); }

	StrainPenalty& penalty_;
	const double first_;
	double stiffness_;
	double sharpness_ = 1;
};

} // namespace developable
