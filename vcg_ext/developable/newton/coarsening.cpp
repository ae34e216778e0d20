// SPDX-License-Identifier: GPL-3.0-or-later
// coarsening.cpp: collapses places into neighbours, sweep by sweep.
#include "coarsening.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace developable::detail {

Coarsening::Coarsening(const PatchAssembly& assembly, const NewtonTuning& tuning)
	: assembly_(assembly), tuning_(tuning), triangles_(assembly.triangleCopies),
	  alive_(assembly.triangleCount(), 1), placeCount_(assembly.placeCount()) {
	fans_.resize(assembly.copyCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		for (int i = assembly.cornerStart[copy]; i < assembly.cornerStart[copy + 1]; ++i)
			fans_[copy].push_back(triangleOf(assembly.corners[i]));
	copies_.resize(assembly.placeCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		copies_[assembly.placeOfCopy[copy]].push_back(copy);
	removed_.assign(assembly.placeCount(), 0);
	findCurves();
}

PartialAssembly Coarsening::coarsen(int placesWanted) {
	constexpr double few = 0.97; // that are left of all by a sweep that was not worth its while
	const double area = copyAreas(assembly_, assembly_.originalPositions).sum();
	const double edge = std::sqrt(2 * area / (std::sqrt(3.0) * placesWanted)); // of even triangles
	shortening_ = tuning_.coarseShortening * edge;
	double share = tuning_.coarseShare;
	while (placeCount_ > placesWanted) {
		const int before = placeCount_;
		sweep(placesWanted, share);
		if (placeCount_ <= few * before)
			continue;
		if (share >= 1)
			break;
		share = std::min(2 * share, 1.0); // most of the smallest are corners, or in the way of each other
	}
	return partialAssembly(assembly_, trianglesWhere(triangles_, [&](int t) { return alive_[t]; }));
}

Eigen::Vector3d Coarsening::placePosition(int place) const {
	return assembly_.originalPositions.col(place);
}

Eigen::Vector3d Coarsening::position(int copy) const {
	return placePosition(assembly_.placeOfCopy[copy]);
}

void Coarsening::findCurves() {
	curveNeighbours_.assign(assembly_.placeCount(), {-1, -1});
	corner_.assign(assembly_.placeCount(), 0);
	for (int h = 0; h < 3 * assembly_.triangleCount(); ++h)
		if (assembly_.across(h) < 0) {
			const int a = assembly_.placeAt(h), b = assembly_.placeAt(nextCorner(h));
			addCurveNeighbour(a, b);
			addCurveNeighbour(b, a);
		}
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		const auto [a, b] = curveNeighbours_[place];
		if (a >= 0 && b < 0)
			corner_[place] = 1;
	}
}

bool Coarsening::turnsSharply(int place) const {
	const auto [a, b] = curveNeighbours_[place];
	if (a < 0)
		return false;
	const Eigen::Vector3d here = placePosition(place), from = placePosition(a), to = placePosition(b);
	return (here - from).norm() + (to - here).norm() - (to - from).norm() > shortening_;
}

std::vector<double> Coarsening::areas() const {
	std::vector<double> areas(assembly_.placeCount(), 0);
	for (int t = 0; t < assembly_.triangleCount(); ++t) {
		if (!alive_[t])
			continue;
		const Eigen::Vector3d corner = position(triangles_(0, t));
		const double doubleArea =
			(position(triangles_(1, t)) - corner).cross(position(triangles_(2, t)) - corner).norm();
		for (const int copy : triangles_.col(t))
			areas[assembly_.placeOfCopy[copy]] += doubleArea;
	}
	return areas;
}

void Coarsening::addCurveNeighbour(int place, int neighbour) {
	auto& [a, b] = curveNeighbours_[place];
	if (a == neighbour || b == neighbour)
		return;
	if (a < 0)
		a = neighbour;
	else if (b < 0)
		b = neighbour;
	else
		corner_[place] = 1;
}

void Coarsening::sweep(int placesWanted, double share) {
	const std::vector<double> areas = this->areas();
	std::vector<double> ofLeft;
	ofLeft.reserve(placeCount_);
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (!removed_[place])
			ofLeft.push_back(areas[place]);
	const auto largest = ofLeft.begin() + static_cast<int>(share * (placeCount_ - 1));
	std::nth_element(ofLeft.begin(), largest, ofLeft.end());
	locked_.assign(assembly_.placeCount(), 0);
	for (int place = 0; place < assembly_.placeCount() && placeCount_ > placesWanted; ++place)
		if (areas[place] <= *largest && !removed_[place] && !locked_[place] && !corner_[place] &&
			!turnsSharply(place) && mayGo(place))
			remove(place);
}

bool Coarsening::mayGo(int place) const {
	if (static_cast<int>(fans_[copies_[place][0]].size()) > tuning_.coarseFan)
		return false;
	if (!assembly_.placeFixed[place])
		return true;
	for (const int copy : copies_[place])
		for (const int t : fans_[copy])
			for (const int other : triangles_.col(t))
				if (!assembly_.placeFixed[assembly_.placeOfCopy[other]])
					return false;
	return true;
}

void Coarsening::remove(int place) {
	double least = tuning_.coarseCotangent;
	int best = -1;
	const auto consider = [&](int neighbour) {
		const double worst = worstAfter(place, neighbour, least);
		if (worst < least) {
			least = worst;
			best = neighbour;
		}
	};
	if (curveNeighbours_[place][0] >= 0)
		for (const int neighbour : curveNeighbours_[place])
			consider(neighbour);
	else
		for (const int t : fans_[copies_[place][0]])
			consider(assembly_.placeOfCopy[triangles_(nextCorner(cornerOfCopy(t, copies_[place][0])), t)]);
	if (best >= 0)
		collapse(place, best);
}

int Coarsening::cornerOfCopy(int triangle, int copy) const {
	const auto corners = triangles_.col(triangle);
	return corners[0] == copy ? 0 : corners[1] == copy ? 1 : 2;
}

int Coarsening::copyBeside(int copy, int place, int& shared) const {
	int found = -1;
	shared = 0;
	for (const int t : fans_[copy])
		for (const int other : triangles_.col(t))
			if (other != copy && assembly_.placeOfCopy[other] == place) {
				if (found >= 0 && other != found)
					shared = 100; // two copies of one place in one fan: leave it
				found = other;
				++shared;
			}
	return found;
}

int Coarsening::commonNeighbours(int copy, int other) const {
	std::vector<int> ring[2];
	for (int side = 0; side < 2; ++side) {
		for (const int t : fans_[side ? other : copy])
			for (const int c : triangles_.col(t))
				ring[side].push_back(c);
		std::sort(ring[side].begin(), ring[side].end());
		ring[side].erase(std::unique(ring[side].begin(), ring[side].end()), ring[side].end());
	}
	std::vector<int> common;
	std::set_intersection(ring[0].begin(), ring[0].end(), ring[1].begin(), ring[1].end(),
						  std::back_inserter(common));
	return static_cast<int>(common.size()) - 2;
}

double Coarsening::worstAfter(int place, int neighbour, double limit) const {
	constexpr double never = std::numeric_limits<double>::infinity();
	const bool onCurve = curveNeighbours_[place][0] >= 0;
	double worst = -never;
	for (const int copy : copies_[place]) {
		int shared = 0;
		const int other = copyBeside(copy, neighbour, shared);
		if (other < 0 || shared != (onCurve ? 1 : 2))
			return never;
		for (const int t : fans_[copy]) {
			if (hasCopy(t, other))
				continue;
			worst = std::max(worst, cotangentAfter(t, copy, other));
			if (worst >= limit)
				return never;
		}
		// The link condition (Dey et al. 1999): else the patch would change its topology.
		if (commonNeighbours(copy, other) != shared || static_cast<int>(fans_[copy].size()) <= shared)
			return never;
	}
	return worst;
}

double Coarsening::cotangentAfter(int triangle, int copy, int other) const {
	Eigen::Vector3d before[3], after[3];
	for (int i = 0; i < 3; ++i) {
		const int c = triangles_(i, triangle);
		before[i] = position(c);
		after[i] = c == copy ? position(other) : before[i];
	}
	const Eigen::Vector3d normalBefore = (before[1] - before[0]).cross(before[2] - before[0]);
	const Eigen::Vector3d normal = (after[1] - after[0]).cross(after[2] - after[0]);
	const double doubleArea = normal.norm();
	if (!(normal.dot(normalBefore) > tuning_.coarseTurn * doubleArea * normalBefore.norm()))
		return std::numeric_limits<double>::infinity();
	double worst = -std::numeric_limits<double>::infinity();
	for (int i = 0; i < 3; ++i)
		worst = std::max(worst, (after[nextCorner(i)] - after[i]).dot(after[previousCorner(i)] - after[i]) /
									doubleArea);
	return worst;
}

void Coarsening::collapse(int place, int neighbour) {
	for (const int copy : copies_[place]) {
		int shared = 0;
		const int other = copyBeside(copy, neighbour, shared);
		for (const int t : fans_[copy])
			for (const int c : triangles_.col(t))
				locked_[assembly_.placeOfCopy[c]] = 1;
		for (const int t : fans_[copy]) {
			if (hasCopy(t, other)) {
				alive_[t] = 0;
				for (const int c : triangles_.col(t))
					if (c != copy)
						fans_[c].erase(std::find(fans_[c].begin(), fans_[c].end(), t));
			} else {
				triangles_(cornerOfCopy(t, copy), t) = other;
				fans_[other].push_back(t);
			}
		}
		fans_[copy] = {};
	}
	removed_[place] = 1;
	--placeCount_;
	for (const int a : curveNeighbours_[place])
		if (a >= 0)
			for (int& b : curveNeighbours_[a])
				if (b == place)
					b = a == neighbour ? otherCurveNeighbour(place, neighbour) : neighbour;
}

int Coarsening::otherCurveNeighbour(int place, int neighbour) const {
	const auto [a, b] = curveNeighbours_[place];
	return a == neighbour ? b : a;
}

} // namespace developable::detail
