// SPDX-License-Identifier: GPL-3.0-or-later
// border_limits.cpp: the turns of borders and their gradients.
#include "border_limits.h"

#include "developable/geometry/geometry.h"

#include <algorithm>

namespace developable::detail {

namespace {

/// The joints of all copies that have two border edges, each once.
std::vector<RodJoint> borderJoints(const PatchAssembly& assembly) {
	std::vector<RodJoint> ofCopy(assembly.copyCount(), {-1, -1, -1});
	std::vector<int> ways(assembly.copyCount(), 0);
	const auto add = [&](int corner, int neighbour) {
		const int copy = assembly.copyAt(corner), way = ways[copy]++;
		ofCopy[copy][1] = assembly.placeAt(corner);
		if (way < 2)
			ofCopy[copy][2 * way] = assembly.placeAt(neighbour);
	};
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
		if (assembly.across(h) < 0) {
			add(h, nextCorner(h));
			add(nextCorner(h), h);
		}
	std::vector<RodJoint> joints;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (ways[copy] == 2) {
			auto [before, place, after] = ofCopy[copy];
			joints.push_back({std::min(before, after), place, std::max(before, after)});
		}
	std::sort(joints.begin(), joints.end());
	joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
	return joints;
}

/// The edges before and after a joint.
struct BorderEdges {
	Eigen::Vector3d in, out;

	BorderEdges(const RodJoint& joint, const Positions& positions)
		: in(positions.col(joint[1]) - positions.col(joint[0])),
		  out(positions.col(joint[2]) - positions.col(joint[1])) {}
};

} // namespace

BorderTurns::BorderTurns(const PatchAssembly& assembly, double more)
	: joints_(borderJoints(assembly)), most_(joints_.size()), mostDirection_(2, joints_.size()) {
	for (std::size_t i = 0; i < joints_.size(); ++i) {
		most_[i] = std::min(turnAt(joints_[i], assembly.originalPositions) + more, pi);
		mostDirection_.col(i) << std::cos(most_[i]), std::sin(most_[i]);
	}
}

Eigen::VectorXd BorderTurns::excess(const Positions& positions) const {
	Eigen::VectorXd result = Eigen::VectorXd::Zero(joints_.size());
	for (std::size_t i = 0; i < joints_.size(); ++i) {
		const BorderEdges edges(joints_[i], positions);
		const double cosine = edges.in.dot(edges.out), sine = edges.in.cross(edges.out).norm();
		// Few turn too much, and the others need no angle.
		if (sine * mostDirection_(0, i) > cosine * mostDirection_(1, i))
			result[i] = std::max(0.0, std::atan2(sine, cosine) - most_[i]);
	}
	return result;
}

Eigen::Vector3d BorderTurns::axis(int joint, const Positions& positions) const {
	const BorderEdges edges(joints_[joint], positions);
	return edges.in.cross(edges.out).normalized();
}

double BorderTurns::excessAbout(const Eigen::Vector3d& axis, int joint, const Positions& positions) const {
	const BorderEdges edges(joints_[joint], positions);
	return std::atan2(edges.in.cross(edges.out).dot(axis), edges.in.dot(edges.out)) - most_[joint];
}

Eigen::Matrix3d BorderTurns::gradientAbout(const Eigen::Vector3d& axis, int joint,
										   const Positions& positions) const {
	const auto [in, out] = BorderEdges(joints_[joint], positions);
	const Eigen::Vector3d byIn = in.cross(axis) / in.squaredNorm(),
						  byOut = axis.cross(out) / out.squaredNorm();
	Eigen::Matrix3d result;
	result << -byIn, byIn - byOut, byOut;
	return result;
}

std::vector<int> copiesThatMayOverlap(const PatchAssembly& assembly) {
	std::vector<int> copies;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (!assembly.copyInterior[copy] && assembly.cornerStart[copy + 1] - assembly.cornerStart[copy] > 2)
			copies.push_back(copy);
	return copies;
}

} // namespace developable::detail
