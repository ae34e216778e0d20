// SPDX-License-Identifier: GPL-3.0-or-later
// box_tree.h: which of many things that move are near a box.
#pragma once

#include "developable/mesh/mesh.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace developable {

/// A box along the axes: the least x, y, z and the least -x, -y, -z in it. So to join two is a minimum, and
/// to compare two takes no branches, which a processor could not foresee among neighbours.
using Box = Eigen::Array<double, 6, 1>;

inline Box boxOf(const Eigen::Matrix3d& points) {
	Box box;
	box << points.rowwise().minCoeff(), -points.rowwise().maxCoeff();
	return box;
}

/// What every box contains.
inline Box emptyBox() {
	return Box::Constant(std::numeric_limits<double>::infinity());
}

inline bool contains(const Box& outer, const Box& inner) {
	return (inner - outer).minCoeff() >= 0;
}

/// What exactly those boxes contain that meet this one (each of its sides is the other's farthest).
inline Box core(const Box& box) {
	Box result;
	result << -box.tail<3>(), -box.head<3>();
	return result;
}

/// A tree of boxes over things of which near ones have near numbers: a node is the box of some that follow
/// each other. Boxes only grow, so that what moves mostly stays in those above its own.
class BoxTree {
public:
	explicit BoxTree(std::vector<Box> boxes);

	/// Takes note of where a thing is now, too.
	void extend(std::size_t item, const Box& box);

	/// All that meet a box, and some that have done so or come near. Good until the next call.
	const std::vector<int>& near(const Box& box);

private:
	static constexpr std::size_t arity = 8;

	std::vector<std::vector<Box>> levels_; ///< the things' own first
	std::vector<int> nodes_, found_;       ///< scratch
};

} // namespace developable
