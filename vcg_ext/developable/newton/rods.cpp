// SPDX-License-Identifier: GPL-3.0-or-later
// rods.cpp: finds borders, seams and creases, and how they go on at each place.
#include "rods.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

/// Whether the triangles at an edge are folded by more than an angle with this cosine.
bool folded(const PatchAssembly& assembly, const Eigen::Matrix3Xd& normals, int halfEdge, int across,
			double cosine) {
	const double sameSide = assembly.copyAt(halfEdge) == assembly.copyAt(across) ? -1 : 1;
	return sameSide * normals.col(triangleOf(halfEdge)).dot(normals.col(triangleOf(across))) < cosine;
}

/// The ends of the edges that are rods, each edge once.
std::vector<std::array<int, 2>> rodEdges(const PatchAssembly& assembly, double creaseCosine) {
	const Eigen::Matrix3Xd normals = unitNormals(assembly, assembly.originalPositions);
	std::vector<std::array<int, 2>> edges;
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.across(halfEdge);
		if (across >= 0 && !folded(assembly, normals, halfEdge, across, creaseCosine))
			continue;
		const int a = assembly.placeAt(halfEdge), b = assembly.placeAt(nextCorner(halfEdge));
		edges.push_back({std::min(a, b), std::max(a, b)});
	}
	std::sort(edges.begin(), edges.end());
	edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
	return edges;
}

/// Two ways out of a place, and the cosine of the turn from the one to the other.
struct Passage {
	double cosine;
	int first, second;
};

/// The passages through a place that turn less than a corner, the straightest first.
std::vector<Passage> straightPassages(const PatchAssembly& assembly, int place, const int* begin,
									  const int* end, const std::vector<int>& neighbours,
									  double cornerCosine) {
	const auto away = [&](int way) -> Eigen::Vector3d {
		return (assembly.originalPositions.col(neighbours[way]) - assembly.originalPositions.col(place))
			.normalized();
	};
	std::vector<Passage> passages;
	for (const int* first = begin; first != end; ++first)
		for (const int* second = first + 1; second != end; ++second) {
			const double cosine = -away(*first).dot(away(*second));
			if (cosine >= cornerCosine)
				passages.push_back({cosine, *first, *second});
		}
	std::stable_sort(passages.begin(), passages.end(),
					 [](const Passage& a, const Passage& b) { return a.cosine > b.cosine; });
	return passages;
}

double cosineOfDegrees(double degrees) {
	return std::cos(degrees * pi / 180);
}

} // namespace

std::vector<RodJoint> rodJoints(const PatchAssembly& assembly, const RodRules& rules) {
	const std::vector<std::array<int, 2>> edges = rodEdges(assembly, cosineOfDegrees(rules.crease));
	const int ways = 2 * static_cast<int>(edges.size()); // way w of edge w / 2 begins at its end w % 2
	std::vector<int> neighbours(ways);
	for (int way = 0; way < ways; ++way)
		neighbours[way] = edges[way / 2][1 - way % 2];
	const Groups byPlace =
		grouped(assembly.placeCount(), ways, [&](int way) { return edges[way / 2][way % 2]; });
	std::vector<RodJoint> joints;
	std::vector<char> used(ways, 0);
	for (int place = 0; place < assembly.placeCount(); ++place)
		for (const Passage& passage :
			 straightPassages(assembly, place, byPlace.begin(place), byPlace.end(place), neighbours,
							  cosineOfDegrees(rules.corner))) {
			if (used[passage.first] || used[passage.second])
				continue;
			used[passage.first] = used[passage.second] = 1;
			joints.push_back({neighbours[passage.first], place, neighbours[passage.second]});
		}
	return joints;
}

Eigen::Vector3d rodBending(const PatchAssembly& assembly, const RodJoint& joint) {
	const auto& positions = assembly.originalPositions;
	const double before = (positions.col(joint[1]) - positions.col(joint[0])).norm(),
				 after = (positions.col(joint[2]) - positions.col(joint[1])).norm();
	return Eigen::Vector3d(1 / before, -1 / before - 1 / after, 1 / after) / std::sqrt((before + after) / 2);
}

double turnAt(const RodJoint& joint, const Positions& positions) {
	const Eigen::Vector3d in = positions.col(joint[1]) - positions.col(joint[0]),
						  out = positions.col(joint[2]) - positions.col(joint[1]);
	return std::atan2(in.cross(out).norm(), in.dot(out));
}

Eigen::VectorXd partAreas(const PatchAssembly& assembly, const Eigen::VectorXd& triangleAreas) {
	DisjointSets parts(assembly.placeCount());
	for (const auto& places : assembly.trianglePlaces.colwise()) {
		parts.unite(places[0], places[1]);
		parts.unite(places[0], places[2]);
	}
	Eigen::VectorXd areas = Eigen::VectorXd::Zero(assembly.placeCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		areas[parts.find(assembly.trianglePlaces(0, t))] += triangleAreas[t];
	for (int place = 0; place < assembly.placeCount(); ++place)
		areas[place] = areas[parts.find(place)];
	return areas;
}

} // namespace developable::detail
