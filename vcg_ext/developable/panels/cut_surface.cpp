// SPDX-License-Identifier: GPL-3.0-or-later
// cut_surface.cpp: dividing and joining panels, and panels as meshes of their own.
#include "cut_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

namespace developable::detail {

namespace {

constexpr double sharpPoint = 0.4; ///< angle defect of the apex of a cone and the like, rad

} // namespace

CutSurface::CutSurface(PatchAssembly assembly)
	: assembly_(std::move(assembly)), cut_(3 * assembly_.triangleCount(), 0),
	  panelOf_(assembly_.patchOfTriangle), triangles_(assembly_.patchCount()),
	  normals_(3, assembly_.triangleCount()), areas_(assembly_.triangleCount()),
	  patchAreas_(Eigen::VectorXd::Zero(assembly_.patchCount())) {
	for (const double defect : angleDefects(assembly_, positions()))
		sharp_.push_back(std::abs(defect) > sharpPoint);
	for (int t = 0; t < assembly_.triangleCount(); ++t) {
		triangles_[panelOf_[t]].push_back(t);
		const Eigen::Vector3d doubled = vectorOf(3 * t).cross(vectorOf(3 * t + 1));
		areas_[t] = doubled.norm() / 2;
		patchAreas_[assembly_.patchOfTriangle[t]] += areas_[t];
		normals_.col(t) = (assembly_.triangleReversed[t] ? -doubled : doubled).normalized();
	}
}

void CutSurface::setCut(int halfEdge, bool cut) {
	cut_[halfEdge] = cut;
	cut_[assembly_.across(halfEdge)] = cut;
}

Eigen::Vector3d CutSurface::vectorOf(int halfEdge) const {
	return positions().col(assembly_.placeAt(nextCorner(halfEdge))) -
		   positions().col(assembly_.placeAt(halfEdge));
}

double CutSurface::area(int panel) const {
	double sum = 0;
	for (const int t : triangles_[panel])
		sum += areas_[t];
	return sum;
}

void CutSurface::divide(int panel, const std::vector<int>& labels) {
	const std::vector<int> members = std::move(triangles_[panel]);
	triangles_[panel].clear();
	std::vector<int> labelOf(assembly_.triangleCount(), -1);
	for (std::size_t i = 0; i < members.size(); ++i)
		labelOf[members[i]] = labels[i];
	for (const int t : members)
		for (int h = 3 * t; h < 3 * t + 3; ++h) {
			const int other = assembly_.across(h);
			if (other >= 0 && panelOf_[triangleOf(other)] == panel &&
				labelOf[triangleOf(other)] != labelOf[t])
				setCut(h, true);
		}
	DisjointSets connected(assembly_.triangleCount());
	for (const int t : members)
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (across(h) >= 0)
				connected.unite(t, triangleOf(across(h)));
	std::vector<int> panelOfRoot(assembly_.triangleCount(), -1);
	for (const int t : members) {
		int& found = panelOfRoot[connected.find(t)];
		if (found < 0) {
			found = triangles_[panel].empty() ? panel : panelCount();
			if (found == panelCount())
				triangles_.emplace_back();
		}
		triangles_[found].push_back(t);
	}
	for (const int t : members)
		panelOf_[t] = panelOfRoot[connected.find(t)];
}

std::vector<int> CutSurface::trianglesAtBothSides(int halfEdge) const {
	const std::vector<int>& own = triangles_[panelOf_[triangleOf(halfEdge)]];
	const std::vector<int>& others = triangles_[panelOf_[triangleOf(assembly_.across(halfEdge))]];
	std::vector<int> both;
	std::set_union(own.begin(), own.end(), others.begin(), others.end(), std::back_inserter(both));
	return both;
}

int CutSurface::join(const std::vector<int>& halfEdges) {
	for (const int h : halfEdges)
		setCut(h, false);
	const int first = panelOf_[triangleOf(halfEdges.front())];
	const int second = panelOf_[triangleOf(assembly_.across(halfEdges.front()))];
	if (first == second)
		return first;
	std::vector<int> united = trianglesAtBothSides(halfEdges.front());
	triangles_[first].clear();
	triangles_[second].clear();
	const int panel = panelCount();
	for (const int t : united)
		panelOf_[t] = panel;
	triangles_.push_back(std::move(united));
	return panel;
}

void CutSurface::relabel(const std::vector<int>& labels) {
	std::fill(cut_.begin(), cut_.end(), 0);
	panelOf_ = assembly_.patchOfTriangle;
	triangles_.assign(assembly_.patchCount(), {});
	for (int t = 0; t < assembly_.triangleCount(); ++t)
		triangles_[panelOf_[t]].push_back(t);
	for (int patch = 0; patch < assembly_.patchCount(); ++patch) {
		std::vector<int> own;
		for (const int t : triangles_[patch])
			own.push_back(labels[t]);
		divide(patch, own);
	}
}

std::vector<int> CutSurface::withoutFragments(std::vector<int> labels) const {
	const int count = assembly_.triangleCount();
	constexpr int rounds = 5; // a fragment may take the label of another
	for (int round = 0; round < rounds; ++round) {
		DisjointSets connected(count);
		for (int h = 0; h < 3 * count; ++h) {
			const int other = assembly_.across(h) < 0 ? -1 : triangleOf(assembly_.across(h));
			if (other >= 0 && labels[other] == labels[triangleOf(h)])
				connected.unite(triangleOf(h), other);
		}
		const Numbering parts = connected.numbering();
		std::vector<double> area(parts.count, 0);
		std::map<std::pair<int, int>, int> largest; // of each label in each patch
		for (int t = 0; t < count; ++t)
			area[parts.number[t]] += areas_[t];
		const auto key = [&](int t) { return std::make_pair(assembly_.patchOfTriangle[t], labels[t]); };
		for (int t = 0; t < count; ++t) {
			int& part = largest.emplace(key(t), parts.number[t]).first->second;
			if (area[parts.number[t]] > area[part])
				part = parts.number[t];
		}
		std::vector<std::map<int, double>> borders(parts.count); // of fragments, by label
		for (int h = 0; h < 3 * count; ++h) {
			const int t = triangleOf(h),
					  other = assembly_.across(h) < 0 ? -1 : triangleOf(assembly_.across(h));
			if (other >= 0 && labels[other] != labels[t] && largest[key(t)] != parts.number[t])
				borders[parts.number[t]][labels[other]] += length(h);
		}
		bool any = false;
		for (int t = 0; t < count; ++t) {
			const auto& border = borders[parts.number[t]];
			if (border.empty())
				continue;
			any = true;
			labels[t] = std::max_element(border.begin(), border.end(), [](const auto& a, const auto& b) {
							return a.second < b.second;
						})->first;
		}
		if (!any)
			break;
	}
	return labels;
}

TriangleMesh CutSurface::meshOf(const std::vector<int>& triangles) const {
	const int count = static_cast<int>(triangles.size());
	const auto local = [&](int triangle) -> int {
		const auto found = std::lower_bound(triangles.begin(), triangles.end(), triangle);
		return found != triangles.end() && *found == triangle ? int(found - triangles.begin()) : -1;
	};
	DisjointSets fans(3 * count);
	for (int i = 0; i < count; ++i)
		for (int corner = 0; corner < 3; ++corner) {
			const int h = cornerOf(triangles[i], corner), other = across(h);
			const int neighbour = other < 0 ? -1 : local(triangleOf(other));
			if (neighbour < 0)
				continue;
			int start = other, end = nextCorner(other);
			if (startOf(start) != startOf(h))
				std::swap(start, end);
			fans.unite(cornerOf(i, corner), cornerOf(neighbour, cornerInTriangle(start)));
			fans.unite(nextCorner(cornerOf(i, corner)), cornerOf(neighbour, cornerInTriangle(end)));
		}
	const Numbering vertices = fans.numbering();
	TriangleMesh mesh;
	mesh.positions.resize(3, vertices.count);
	mesh.triangles.resize(3, count);
	for (int corner = 0; corner < 3 * count; ++corner) {
		mesh.triangles.data()[corner] = vertices.number[corner];
		const int place =
			assembly_.placeAt(cornerOf(triangles[triangleOf(corner)], cornerInTriangle(corner)));
		mesh.positions.col(vertices.number[corner]) = positions().col(place);
	}
	mesh.vertexSelected.assign(vertices.count, 0);
	mesh.triangleSelected.assign(count, 0);
	mesh.face = triangles;
	mesh.leastHeightRatio = assembly_.leastHeightRatio;
	mesh.lengthExponent = assembly_.lengthExponent;
	return mesh;
}

int eulerCharacteristic(const CutSurface& surface, int panel) {
	const PatchAssembly assembly = assemblePatches(surface.meshOf(surface.trianglesOf(panel)), {});
	return assembly.patchCount() == 1 ? assembly.patches[0].eulerCharacteristic() : 2;
}

} // namespace developable::detail
