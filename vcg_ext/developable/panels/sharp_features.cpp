// SPDX-License-Identifier: GPL-3.0-or-later
// sharp_features.cpp: every edge and point beside those next to it.
#include "sharp_features.h"

#include <algorithm>
#include <cmath>

namespace developable::detail {

namespace {

constexpr double muchLess = 0.5; ///< share of a turn or a defect: what is next to a crease or point at most

/// The greatest turn of the edges on one side of an edge that lie opposite to it, in the triangles next to
/// its own: along a crease it may turn as much as it likes, beside it not.
double turnBeside(const CutSurface& surface, int halfEdge) {
	double greatest = 0;
	for (const int side : {nextCorner(halfEdge), previousCorner(halfEdge)}) {
		const int other = surface.assembly().across(side);
		if (other < 0)
			continue;
		for (const int h : {nextCorner(other), previousCorner(other)}) {
			const bool touches = surface.startOf(h) == surface.startOf(halfEdge) ||
								 surface.endOf(h) == surface.startOf(halfEdge) ||
								 surface.startOf(h) == surface.endOf(halfEdge) ||
								 surface.endOf(h) == surface.endOf(halfEdge);
			if (!touches)
				greatest = std::max(greatest, turnAt(surface, h));
		}
	}
	return greatest;
}

constexpr double nearlyAsSharp = 0.7;    ///< share of the sharpest edge at a point: less is beside a line
constexpr double leastSides = 5;         ///< of a prism that is meant to be round
constexpr double zigzag = 45 * pi / 180; ///< a line of creases that turns by more there is a jagged one

/// Per half edge, how it goes on at its ends where it does in one other of some edges.
struct SharpLines {
	std::vector<char> jagged; ///< it turns sharply at one of them
	std::vector<char> smooth; ///< it goes on straight, or nearly, at one
};

/// The ends of sharp edges at a place, without those that are beside a much sharper line.
std::vector<int> sharpestOf(const CutSurface& surface, std::vector<int> halfEdges) {
	double sharpest = 0;
	for (const int h : halfEdges)
		sharpest = std::max(sharpest, turnAt(surface, h));
	halfEdges.erase(std::remove_if(halfEdges.begin(), halfEdges.end(),
								   [&](int h) { return turnAt(surface, h) < nearlyAsSharp * sharpest; }),
					halfEdges.end());
	return halfEdges;
}

SharpLines sharpLines(const CutSurface& surface, const std::vector<char>& isSharp) {
	std::vector<std::vector<int>> at(
		surface.assembly().copyCount()); // half edges of sharp edges, by their ends
	for (int h = 0; h < static_cast<int>(isSharp.size()); ++h)
		if (isSharp[h] && h < surface.assembly().across(h)) {
			at[surface.startOf(h)].push_back(h);
			at[surface.endOf(h)].push_back(h);
		}
	SharpLines lines{std::vector<char>(isSharp.size(), 0), std::vector<char>(isSharp.size(), 0)};
	for (int copy = 0; copy < static_cast<int>(at.size()); ++copy) {
		const std::vector<int> sharpest = sharpestOf(surface, std::move(at[copy]));
		if (sharpest.size() != 2) // ends, and where several meet
			continue;
		const auto outward = [&](int h) -> Eigen::Vector3d {
			return (surface.startOf(h) == copy ? 1 : -1) * surface.vectorOf(h).normalized();
		};
		const bool straight = outward(sharpest[0]).dot(-outward(sharpest[1])) >= std::cos(zigzag);
		std::vector<char>& kind = straight ? lines.smooth : lines.jagged;
		for (const int h : sharpest)
			kind[h] = kind[surface.assembly().across(h)] = 1;
	}
	return lines;
}

std::vector<SharpFeatures::Kind> sharpEdges(const CutSurface& surface, double creaseAngle) {
	const int count = 3 * surface.assembly().triangleCount();
	std::vector<char> isSharp(count);
	for (int h = 0; h < count; ++h)
		isSharp[h] = turnAt(surface, h) > creaseAngle * pi / 180;
	const SharpLines lines = sharpLines(surface, isSharp);
	std::vector<SharpFeatures::Kind> kinds(count, SharpFeatures::None);
	for (int h = 0; h < count; ++h) {
		if (!isSharp[h])
			continue;
		const int other = surface.assembly().across(h);
		const bool crease = lines.smooth[h] && turnAt(surface, h) > 2 * pi / leastSides;
		const double beside = std::max(turnBeside(surface, h), turnBeside(surface, other));
		const bool alone = !lines.jagged[h] && (crease || beside <= muchLess * turnAt(surface, h));
		kinds[h] = alone ? SharpFeatures::Alone : SharpFeatures::AmongOthers;
	}
	return kinds;
}

std::vector<SharpFeatures::Kind> sharpPoints(const CutSurface& surface) {
	const Eigen::VectorXd defects = angleDefects(surface.assembly(), surface.positions()).cwiseAbs();
	Eigen::VectorXd beside = Eigen::VectorXd::Zero(defects.size());
	for (int h = 0; h < 3 * surface.assembly().triangleCount(); ++h) {
		const int a = surface.startOf(h), b = surface.endOf(h);
		beside[a] = std::max(beside[a], defects[b]);
		beside[b] = std::max(beside[b], defects[a]);
	}
	std::vector<SharpFeatures::Kind> kinds(defects.size(), SharpFeatures::None);
	for (int copy = 0; copy < static_cast<int>(kinds.size()); ++copy)
		if (surface.isSharpPoint(copy))
			kinds[copy] =
				beside[copy] <= muchLess * defects[copy] ? SharpFeatures::Alone : SharpFeatures::AmongOthers;
	return kinds;
}

} // namespace

double turnAt(const CutSurface& surface, int halfEdge) {
	const int other = surface.assembly().across(halfEdge);
	if (other < 0)
		return 0;
	const Eigen::Vector3d a = surface.normals().col(triangleOf(halfEdge));
	const Eigen::Vector3d b = surface.normals().col(triangleOf(other));
	return std::atan2(a.cross(b).norm(), a.dot(b));
}

SharpFeatures sharpFeatures(const CutSurface& surface, double creaseAngle) {
	return {sharpEdges(surface, creaseAngle), sharpPoints(surface)};
}

} // namespace developable::detail
