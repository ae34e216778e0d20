// SPDX-License-Identifier: GPL-3.0-or-later
// border_parts.cpp: round a piece, half edge by half edge.
#include "border_parts.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace developable::detail {

namespace {

/// Round a piece, from half edge to half edge.
class Border {
public:
	/// \param leaving  per vertex a half edge of the borders that begins there
	Border(const FlatPatterns& patterns, const std::vector<int>& leaving, int first) {
		double length = 0;
		for (int h = first; order_.size() < patterns.joinedHalfEdge.size();) {
			place_[h] = static_cast<int>(order_.size());
			order_.push_back(h);
			begins_.push_back(length);
			length += patterns.length(h);
			h = leaving[patterns.vertexAt(nextCorner(h))];
			if (h == first)
				break;
		}
		begins_.push_back(length);
		closed_ = leaving[patterns.vertexAt(nextCorner(order_.back()))] == first;
	}

	bool has(int halfEdge) const { return place_.count(halfEdge) > 0; }
	BorderWay shorterWay(int a, int b) const {
		return detail::shorterWay(begins_, place_.at(a), place_.at(b));
	}
	bool isWithin(const BorderWay& part, const BorderWay& whole) const {
		const int after = (part.first - whole.first + size()) % size();
		return after + part.count <= whole.count;
	}
	BorderPart partOf(const BorderWay& way) const {
		BorderPart part;
		for (int i = 0; i < way.count; ++i)
			part.halfEdges.push_back(order_[(way.first + i) % size()]);
		part.share = way.length / begins_.back();
		return part;
	}
	/// A border that touches itself at a vertex has two ways on there, of which one may never lead back.
	bool isClosed() const { return closed_; }
	/// Where each half edge begins.
	Eigen::Matrix2Xd points(const FlatPatterns& patterns) const {
		Eigen::Matrix2Xd result(2, size());
		for (int i = 0; i < size(); ++i)
			result.col(i) = patterns.positions.col(patterns.vertexAt(order_[i]));
		return result;
	}

private:
	int size() const { return static_cast<int>(order_.size()); }

	std::vector<int> order_;
	std::vector<double> begins_; // of each, from the first on; and of all
	std::unordered_map<int, int> place_;
	bool closed_ = false;
};

std::vector<int> leavingHalfEdges(const FlatPatterns& patterns) {
	std::vector<int> leaving(patterns.vertexCount(), -1);
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h)
		if (patterns.joinedHalfEdge[h] < 0)
			leaving[patterns.vertexAt(h)] = h;
	return leaving;
}

/// Ways that are no part of others; of equal ones the first.
std::vector<BorderWay> largestOf(std::vector<BorderWay> ways, const Border& border) {
	std::stable_sort(ways.begin(), ways.end(),
					 [](const auto& a, const auto& b) { return a.count > b.count; });
	std::vector<BorderWay> largest;
	for (const BorderWay& way : ways)
		if (std::none_of(largest.begin(), largest.end(),
						 [&](const BorderWay& other) { return border.isWithin(way, other); }))
			largest.push_back(way);
	return largest;
}

} // namespace

std::vector<BorderPart> notchesOf(const FlatPatterns& patterns, const FlatPiece& piece) {
	std::vector<std::pair<Border, std::vector<BorderWay>>> borders;
	std::vector<int> leaving;
	for (const auto& [a, b] : piece.crossings) {
		auto at = std::find_if(borders.begin(), borders.end(),
							   [first = a](const auto& one) { return one.first.has(first); });
		if (leaving.empty())
			leaving = leavingHalfEdges(patterns);
		if (at == borders.end())
			at = borders.insert(at, {Border(patterns, leaving, a), {}});
		if (!at->first.isClosed() || !at->first.has(b))
			return {BorderPart()};
		at->second.push_back(at->first.shorterWay(a, b));
	}
	std::vector<BorderPart> notches;
	for (const auto& [border, ways] : borders)
		for (const BorderWay& way : largestOf(ways, border))
			notches.push_back(border.partOf(way));
	return notches;
}

double coveredStretch(const FlatPatterns& patterns, const FlatPiece& piece) {
	constexpr double whole = std::numeric_limits<double>::infinity();
	if (piece.crossings.empty())
		return whole;
	const Border border(patterns, leavingHalfEdges(patterns), piece.crossings.front()[0]);
	const bool isOne = border.isClosed() &&
					   std::all_of(piece.crossings.begin(), piece.crossings.end(), [&](const auto& crossing) {
						   return border.has(crossing[0]) && border.has(crossing[1]);
					   });
	return isOne ? longestCoveredStretch(border.points(patterns)) : whole;
}

const BorderPart& largestNotch(const std::vector<BorderPart>& notches) {
	return *std::max_element(notches.begin(), notches.end(),
							 [](const BorderPart& a, const BorderPart& b) { return a.share < b.share; });
}

} // namespace developable::detail
