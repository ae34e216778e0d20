// SPDX-License-Identifier: GPL-3.0-or-later
// grain.h: which way the grain runs on a model.
#pragma once

#include <Eigen/Core>

namespace developable {

/// Which way the warp runs in each panel.
class Grain {
public:
	/// The numbers are part of the interface.
	enum Choice {
		LongestSeam = 0, ///< along the panel's longest seam, or its longest side where it has none
		XAxis = 1,       ///< as nearly along that axis of the model as can be, on the mean over the panel
		YAxis = 2,
		ZAxis = 3
	};

	Grain(Choice choice); ///< implicit: a choice is a grain

	/// As nearly along any direction of the model.
	/// \throws InvalidParameter  when it has no length, or no finite one
	explicit Grain(const Eigen::Vector3d& direction);

	bool alongSeam() const { return direction_.isZero(0); }

	/// On the model, unit length; 0 along seams.
	const Eigen::Vector3d& direction() const { return direction_; }

	bool operator==(const Grain& other) const { return direction_ == other.direction_; }

private:
	Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
};

} // namespace developable
