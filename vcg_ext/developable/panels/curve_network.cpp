// SPDX-License-Identifier: GPL-3.0-or-later
// curve_network.cpp: nodes round each triangle, and what lies between them.
#include "curve_network.h"

#include "triangle_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace developable::detail {

namespace {

/// Of every edge; nearer to its ends and to each other triangles would become too flat.
constexpr double sharesOnEdge[] = {0.25, 0.5, 0.75};
constexpr int perEdge = std::size(sharesOnEdge);
constexpr double apart = 0.15; ///< of an edge, between nodes of curves

} // namespace

CurveNetwork::CurveNetwork(const TriangleMesh& mesh, const CutSurface& surface)
	: mesh_(mesh), assembly_(surface.assembly()),
	  cornersAt_(grouped(mesh.vertexCount(), 3 * mesh.triangleCount(),
						 [&](int corner) { return vertexAt(mesh, corner); })) {
	for (int h = 3 * mesh.triangleCount() - 1; h >= 0; --h) {
		const int a = vertexAt(mesh, h), b = vertexAt(mesh, nextCorner(h));
		halfEdges_[std::minmax({a, b})] = h;
	}
}

int CurveNetwork::firstOf(int halfEdge) const {
	const int other = assembly_.across(halfEdge);
	return other < 0 ? halfEdge : std::min(halfEdge, other);
}

CurveNetwork::EdgePoint CurveNetwork::edgePointOf(int node) const {
	const int number = node - mesh_.vertexCount();
	const int ofEdges = perEdge * 3 * mesh_.triangleCount();
	if (number >= ofEdges)
		return others_[number - ofEdges];
	return {number / perEdge, sharesOnEdge[number % perEdge]};
}

int CurveNetwork::nodeAt(const VertexOrigin& place) {
	if (place.first == place.second)
		return place.first;
	const int h = firstOf(halfEdges_.at(std::minmax({place.first, place.second})));
	const double share = vertexAt(mesh_, h) == place.first ? place.share : 1 - place.share;
	const int next = mesh_.vertexCount() + perEdge * 3 * mesh_.triangleCount() + int(others_.size());
	const auto [found, isNew] = othersOn_[h].emplace(share, next);
	if (isNew)
		others_.push_back({h, share});
	return found->second;
}

Eigen::Vector3d CurveNetwork::pointOf(int node) const {
	if (vertexOf(node) >= 0)
		return mesh_.positions.col(node);
	const EdgePoint at = edgePointOf(node);
	return (1 - at.share) * mesh_.positions.col(vertexAt(mesh_, at.halfEdge)) +
		   at.share * mesh_.positions.col(vertexAt(mesh_, nextCorner(at.halfEdge)));
}

std::vector<int> CurveNetwork::trianglesAt(int node) const {
	std::vector<int> triangles;
	if (vertexOf(node) >= 0) {
		for (const int* corner = cornersAt_.begin(node); corner != cornersAt_.end(node); ++corner)
			triangles.push_back(triangleOf(*corner));
		return triangles;
	}
	const int h = edgePointOf(node).halfEdge, other = assembly_.across(h);
	triangles.push_back(triangleOf(h));
	if (other >= 0)
		triangles.push_back(triangleOf(other));
	return triangles;
}

/// Where on the way round a triangle a node is, 0 to 3: corners are whole numbers. Negative: nowhere.
double CurveNetwork::placeIn(int triangle, int node) const {
	for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
		if (vertexOf(node) >= 0) {
			if (vertexAt(mesh_, h) == node)
				return cornerInTriangle(h);
			continue;
		}
		const EdgePoint at = edgePointOf(node);
		if (firstOf(h) != at.halfEdge)
			continue;
		const bool same = vertexAt(mesh_, h) == vertexAt(mesh_, at.halfEdge);
		return cornerInTriangle(h) + (same ? at.share : 1 - at.share);
	}
	return -1;
}

/// The half edge of a triangle on which two nodes lie; -1: none.
int CurveNetwork::sideOf(int triangle, int a, int b) const {
	const double first = placeIn(triangle, a), second = placeIn(triangle, b);
	for (int corner = 0; corner < 3; ++corner) {
		const auto on = [&](double place) {
			return (place >= corner && place <= corner + 1) || (corner == 2 && place == 0);
		};
		if (on(first) && on(second))
			return 3 * triangle + corner;
	}
	return -1;
}

/// Nodes inside a side of a triangle that curves go through.
std::vector<int> CurveNetwork::takenOn(int side) const {
	const auto found = takenOn_.find(firstOf(side));
	return found == takenOn_.end() ? std::vector<int>()
								   : std::vector<int>(found->second.begin(), found->second.end());
}

/// Whether a curve runs along an edge there.
bool CurveNetwork::isInsideSegment(int halfEdge, double share) const {
	const auto found = along_.find(halfEdge);
	if (found == along_.end())
		return false;
	const int end = vertexAt(mesh_, nextCorner(halfEdge));
	const auto shareOf = [&](int node) {
		return vertexOf(node) < 0 ? edgePointOf(node).share : node == end ? 1.0 : 0.0;
	};
	return std::any_of(found->second.begin(), found->second.end(), [&](const Segment& segment) {
		const auto [low, high] = std::minmax({shareOf(segment.first), shareOf(segment.second)});
		return share > low && share < high;
	});
}

std::vector<int> CurveNetwork::freeNodes(int triangle) const {
	std::vector<int> nodes;
	for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
		const int vertex = vertexAt(mesh_, h);
		if (assembly_.copyInterior[assembly_.copyAt(h)] && taken_.count(vertex) == 0)
			nodes.push_back(vertex);
		const int first = firstOf(h);
		if (assembly_.across(h) < 0)
			continue;
		const std::vector<int> taken = takenOn(h);
		for (int i = 0; i < perEdge; ++i) {
			const bool tooNear = std::any_of(taken.begin(), taken.end(), [&](int node) {
				return std::abs(edgePointOf(node).share - sharesOnEdge[i]) < apart;
			});
			if (!tooNear && !isInsideSegment(first, sharesOnEdge[i]))
				nodes.push_back(mesh_.vertexCount() + perEdge * first + i);
		}
	}
	return nodes;
}

bool CurveNetwork::mayRun(int triangle, int from, int to) const {
	const double a = placeIn(triangle, from), b = placeIn(triangle, to);
	const auto between = [&](int node) {
		const double place = placeIn(triangle, node);
		return place > std::min(a, b) && place < std::max(a, b);
	};
	const int side = sideOf(triangle, from, to);
	if (side >= 0) {                            // along an edge: nothing may begin on the way
		const bool wraps = std::abs(a - b) > 1; // the third side ends where the first begins
		const std::vector<int> taken = takenOn(side);
		return std::none_of(taken.begin(), taken.end(), [&](int node) {
			return node != from && node != to &&
				   (wraps ? placeIn(triangle, node) > std::max(a, b) : between(node));
		});
	}
	const auto chords = chords_.find(triangle);
	if (chords == chords_.end())
		return true;
	return std::none_of(chords->second.begin(), chords->second.end(), [&](const Segment& chord) {
		const bool meets =
			chord.first == from || chord.first == to || chord.second == from || chord.second == to;
		return !meets && between(chord.first) != between(chord.second);
	});
}

std::vector<int> CurveNetwork::trianglesOfStep(int a, int b) const {
	std::vector<int> both;
	for (const int t : trianglesAt(a))
		if (placeIn(t, b) >= 0)
			both.push_back(t);
	return both;
}

void CurveNetwork::change(const std::vector<int>& curve, int by) {
	for (std::size_t i = 0; i < curve.size(); ++i) {
		if ((taken_[curve[i]] += by) == 0)
			taken_.erase(curve[i]);
		if (vertexOf(curve[i]) < 0) {
			std::set<int>& on = takenOn_[edgePointOf(curve[i]).halfEdge];
			if (taken_.count(curve[i]) > 0)
				on.insert(curve[i]);
			else
				on.erase(curve[i]);
		}
		if (i == 0)
			continue;
		const int t = trianglesOfStep(curve[i - 1], curve[i]).front();
		const int side = sideOf(t, curve[i - 1], curve[i]);
		std::set<Segment>& segments = side >= 0 ? along_[firstOf(side)] : chords_[t];
		const Segment segment = std::minmax({curve[i - 1], curve[i]});
		if (by > 0)
			segments.insert(segment);
		else
			segments.erase(segment);
	}
}

void CurveNetwork::add(const std::vector<int>& curve) {
	change(curve, 1);
}

void CurveNetwork::remove(const std::vector<int>& curve) {
	change(curve, -1);
}

/// The corners of a triangle and the nodes on its sides that curves go through, in order.
std::vector<int> CurveNetwork::nodesRound(int triangle) const {
	std::vector<std::pair<double, int>> round;
	for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
		round.emplace_back(cornerInTriangle(h), vertexAt(mesh_, h));
		for (const int node : takenOn(h))
			round.emplace_back(placeIn(triangle, node), node);
	}
	std::sort(round.begin(), round.end());
	std::vector<int> nodes;
	nodes.reserve(round.size());
	for (const auto& [place, node] : round)
		nodes.push_back(node);
	return nodes;
}

/// What curves run across a triangle and along its sides.
std::set<CurveNetwork::Segment> CurveNetwork::segmentsOf(int triangle) const {
	std::set<Segment> segments;
	const auto chords = chords_.find(triangle);
	if (chords != chords_.end())
		segments = chords->second;
	for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
		const auto along = along_.find(firstOf(h));
		if (along != along_.end())
			segments.insert(along->second.begin(), along->second.end());
	}
	return segments;
}

void CurveNetwork::splitTriangle(int triangle, const std::map<int, int>& vertexOfNode,
								 std::vector<Eigen::Vector3i>& triangles, SplitMesh& result,
								 std::vector<char>& isCut) const {
	const std::vector<int> round = nodesRound(triangle);
	const std::set<Segment> segments = segmentsOf(triangle);
	std::map<int, int> cornerOf;
	Eigen::Matrix3Xd points(3, round.size());
	for (std::size_t i = 0; i < round.size(); ++i) {
		cornerOf[round[i]] = static_cast<int>(i);
		points.col(i) = pointOf(round[i]);
	}
	std::vector<std::pair<int, int>> chords;
	for (const auto& [a, b] : segments)
		if (cornerOf.count(a) > 0 && cornerOf.count(b) > 0)
			chords.emplace_back(cornerOf.at(a), cornerOf.at(b));
	for (const std::array<int, 3>& corners : trianglesOfPolygon(points, chords)) {
		Eigen::Vector3i vertices;
		for (int i = 0; i < 3; ++i) {
			const int node = round[corners[i]], next = round[corners[(i + 1) % 3]];
			vertices[i] = vertexOf(node) >= 0 ? node : vertexOfNode.at(node);
			isCut.push_back(segments.count(std::minmax({node, next})) > 0);
		}
		triangles.push_back(vertices);
		result.mesh.face.push_back(triangle);
		result.mesh.triangleSelected.push_back(mesh_.triangleSelected[triangle]);
	}
}

SplitMesh CurveNetwork::split(std::vector<char>& isCut) const {
	SplitMesh result;
	result.mesh.leastHeightRatio = mesh_.leastHeightRatio;
	result.mesh.lengthExponent = mesh_.lengthExponent;
	result.mesh.positions = mesh_.positions;
	for (int vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
		result.origins.push_back({vertex, vertex, 0});
	std::map<int, int> vertexOfNode; // of those on edges
	for (const auto& [node, curves] : taken_)
		if (vertexOf(node) < 0) {
			const EdgePoint at = edgePointOf(node);
			vertexOfNode[node] = static_cast<int>(result.origins.size());
			result.origins.push_back(
				{vertexAt(mesh_, at.halfEdge), vertexAt(mesh_, nextCorner(at.halfEdge)), at.share});
		}
	result.mesh.positions.conservativeResize(3, result.origins.size());
	for (const auto& [node, vertex] : vertexOfNode)
		result.mesh.positions.col(vertex) = pointOf(node);
	result.mesh.vertexSelected.assign(result.origins.size(), 0);
	isCut.clear();
	std::vector<Eigen::Vector3i> triangles;
	for (int t = 0; t < mesh_.triangleCount(); ++t)
		splitTriangle(t, vertexOfNode, triangles, result, isCut);
	result.mesh.triangles.resize(3, triangles.size());
	for (int t = 0; t < result.mesh.triangleCount(); ++t)
		result.mesh.triangles.col(t) = triangles[t];
	return result;
}

} // namespace developable::detail
