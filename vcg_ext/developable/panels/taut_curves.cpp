// SPDX-License-Identifier: GPL-3.0-or-later
// taut_curves.cpp: Dijkstra's algorithm in a channel round each curve, the others being walls.
#include "taut_curves.h"

#include "curve_network.h"
#include "seam_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace developable::detail {

namespace {

constexpr double seamChannel = 0.5, dartChannel = 1; ///< half width, mean edge lengths
constexpr int rounds = 2;                            ///< curves make room for each other

double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
	const double length = (b - a).squaredNorm();
	const double share = length > 0 ? (point - a).dot(b - a) / length : 0;
	return (a + std::min(std::max(share, 0.0), 1.0) * (b - a) - point).norm();
}

/// The shortest way between two nodes that crosses no curve, in a channel round a line.
class ChannelRoute {
public:
	/// \param middle  of the channel, points in order
	/// \param held    per triangle, or empty
	ChannelRoute(const CurveNetwork& network, const std::vector<Eigen::Vector3d>& middle, double halfWidth,
				 const std::vector<char>& held)
		: network_(network), middle_(middle), halfWidth_(halfWidth), held_(held) {}

	/// \return its nodes, none if there is no way
	std::vector<int> between(int start, int end) {
		length_[start] = 0;
		front_.emplace(0, start);
		while (!front_.empty()) {
			const auto [length, node] = front_.top();
			front_.pop();
			if (node == end)
				return wayTo(start, end);
			if (length > length_[node])
				continue;
			for (const int t : network_.trianglesAt(node))
				if (held_.empty() || !held_[t])
					goOn(t, node, end);
		}
		return {};
	}

private:
	using Step = std::pair<double, int>;

	/// From a node across a triangle.
	void goOn(int triangle, int node, int end) {
		for (const int next : nodesOf(triangle, end)) {
			if (next == node || !network_.mayRun(triangle, node, next))
				continue;
			const double further = length_[node] + (network_.pointOf(next) - network_.pointOf(node)).norm();
			const auto found = length_.find(next);
			if (found != length_.end() && found->second <= further)
				continue;
			length_[next] = further;
			from_[next] = node;
			front_.emplace(further, next);
		}
	}

	std::vector<int> wayTo(int start, int end) const {
		std::vector<int> way = {end};
		while (way.back() != start)
			way.push_back(from_.at(way.back()));
		std::reverse(way.begin(), way.end());
		return way;
	}

	/// The free nodes of a triangle within the channel, and the end.
	const std::vector<int>& nodesOf(int triangle, int end) {
		const auto [found, isNew] = nodes_.try_emplace(triangle);
		if (!isNew)
			return found->second;
		for (const int node : network_.freeNodes(triangle))
			if (node != end && isWithin(node) && !splitsHeld(node))
				found->second.push_back(node);
		const std::vector<int> atEnd = network_.trianglesAt(end);
		if (std::find(atEnd.begin(), atEnd.end(), triangle) != atEnd.end())
			found->second.push_back(end);
		return found->second;
	}

	/// What is held keeps its sides whole.
	bool splitsHeld(int node) const {
		const std::vector<int> triangles = network_.trianglesAt(node);
		return !held_.empty() && network_.vertexOf(node) < 0 &&
			   std::any_of(triangles.begin(), triangles.end(), [&](int t) { return held_[t] != 0; });
	}

	bool isWithin(int node) const {
		const Eigen::Vector3d point = network_.pointOf(node);
		for (std::size_t i = 1; i < middle_.size(); ++i)
			if (distanceToSegment(point, middle_[i - 1], middle_[i]) <= halfWidth_)
				return true;
		return false;
	}

	const CurveNetwork& network_;
	const std::vector<Eigen::Vector3d>& middle_;
	const double halfWidth_;
	const std::vector<char>& held_;
	std::priority_queue<Step, std::vector<Step>, std::greater<>> front_;
	std::map<int, double> length_;
	std::map<int, int> from_;
	std::map<int, std::vector<int>> nodes_; // of each triangle that was seen
};

int dartCount(const CutSurface& surface) {
	const std::vector<SeamChain> chains = seamChains(surface);
	return static_cast<int>(
		std::count_if(chains.begin(), chains.end(), [](const SeamChain& chain) { return chain.isDart(); }));
}

class CurveTightening {
public:
	CurveTightening(const DrawnSeams& drawn, const PlannedSurface& planned, const SharpFeatures& features,
					const TautLimits& limits)
		: drawn_(drawn), planned_(planned), features_(features), limits_(limits),
		  network_(planned.mesh, planned.surface), edge_(meanEdgeLength(planned.surface.assembly())) {
		for (const SeamChain& chain : seamChains(drawn.surface))
			addCurves(chain);
	}

	DrawnSeams taut() {
		for (int round = 0; round < rounds; ++round)
			for (Curve& curve : curves_)
				tighten(curve);
		std::vector<char> isCut;
		SplitMesh split = network_.split(isCut);
		CutSurface surface(assemblePatches(split.mesh, {}));
		DisjointSets connected(split.mesh.triangleCount());
		const auto across = [&](int h) { return surface.assembly().across(h); };
		for (int h = 0; h < static_cast<int>(isCut.size()); ++h)
			if (!isCut[h] && across(h) >= 0)
				connected.unite(triangleOf(h), triangleOf(across(h)));
		split.labels = connected.numbering().number;
		surface.relabel(split.labels);
		for (int h = 0; h < static_cast<int>(isCut.size()); ++h)
			if (isCut[h] && across(h) >= 0)
				surface.setCut(h, true);
		return {std::move(split), std::move(surface)};
	}

private:
	struct Curve {
		std::vector<int> nodes;
		std::vector<Eigen::Vector3d> middle; ///< of its channel
		double halfWidth = 0;
	};

	/// A chain between its ends and between what stays on it.
	void addCurves(const SeamChain& chain) {
		std::vector<int> nodes = {nodeOf(chain.ends[0])};
		int copy = chain.ends[0];
		for (const int h : chain.halfEdges) {
			copy = drawn_.surface.startOf(h) == copy ? drawn_.surface.endOf(h) : drawn_.surface.startOf(h);
			nodes.push_back(nodeOf(copy));
		}
		const bool closed = chain.ends[0] == chain.ends[1];
		const double halfWidth = edge_ * (chain.isDart() ? dartChannel : seamChannel);
		std::size_t begin = 0;
		for (std::size_t i = 1; i < nodes.size(); ++i)
			if (i + 1 == nodes.size() || stays(nodes[i]) || (closed && i == nodes.size() / 2)) {
				Curve curve{{nodes.begin() + begin, nodes.begin() + i + 1}, {}, halfWidth};
				for (const int node : curve.nodes)
					curve.middle.push_back(network_.pointOf(node));
				network_.add(curve.nodes);
				curves_.push_back(std::move(curve));
				begin = i;
			}
	}

	int nodeOf(int copy) {
		const int corner = drawn_.surface.assembly().corners[drawn_.surface.assembly().cornerStart[copy]];
		return network_.nodeAt(drawn_.split.origins[vertexAt(drawn_.split.mesh, corner)]);
	}

	/// Whether seams that go through a node may not move, lie on a crease or go through a sharp point.
	bool stays(int node) const {
		const std::vector<int> triangles = network_.trianglesAt(node);
		if (std::any_of(triangles.begin(), triangles.end(), [&](int t) { return limits_.stays[t] != 0; }))
			return true;
		if (network_.vertexOf(node) < 0)
			return false;
		return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
			for (int h = 3 * t; h < 3 * t + 3; ++h) {
				const bool starts = vertexAt(planned_.mesh, h) == node;
				const bool touches = starts || vertexAt(planned_.mesh, nextCorner(h)) == node;
				if ((touches && features_.edges[h] == SharpFeatures::Alone) ||
					(starts && features_.points[planned_.surface.startOf(h)] == SharpFeatures::Alone))
					return true;
			}
			return false;
		});
	}

	double lengthOf(const std::vector<int>& nodes) const {
		double length = 0;
		for (std::size_t i = 1; i < nodes.size(); ++i)
			length += (network_.pointOf(nodes[i]) - network_.pointOf(nodes[i - 1])).norm();
		return length;
	}

	void tighten(Curve& curve) {
		if (curve.nodes.size() < 3)
			return;
		network_.remove(curve.nodes);
		const std::vector<int> route = ChannelRoute(network_, curve.middle, curve.halfWidth, limits_.held)
										   .between(curve.nodes.front(), curve.nodes.back());
		if (!route.empty() && lengthOf(route) < lengthOf(curve.nodes))
			curve.nodes = route;
		network_.add(curve.nodes);
	}

	const DrawnSeams& drawn_;
	const PlannedSurface& planned_;
	const SharpFeatures& features_;
	const TautLimits& limits_;
	CurveNetwork network_;
	const double edge_;
	std::vector<Curve> curves_;
};

} // namespace

DrawnSeams pulledTaut(DrawnSeams drawn, const PlannedSurface& planned, const SharpFeatures& features,
					  const TautLimits& limits) {
	DrawnSeams taut = CurveTightening(drawn, planned, features, limits).taut();
	const bool same = taut.surface.usedPanelCount() == drawn.surface.usedPanelCount() &&
					  dartCount(taut.surface) == dartCount(drawn.surface);
	return same ? std::move(taut) : std::move(drawn);
}

} // namespace developable::detail
