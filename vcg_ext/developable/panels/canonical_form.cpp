// SPDX-License-Identifier: GPL-3.0-or-later
// canonical_form.cpp: rounded and sorted for every candidate of axes.
#include "canonical_form.h"

#include "candidate_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace developable::detail {

namespace {

using Cells = std::vector<std::array<std::int64_t, 3>>;

constexpr double coarsest = 0x1p-22;     ///< of the radius of gyration: the side of a cell
constexpr double shareOfEdge = 0x1p-10;  ///< or of the shortest edge
constexpr double shareOfHeight = 0x1p-4; ///< or of the least height of a triangle
constexpr double finest = 0x1p-44;       ///< that doubles can tell anywhere on the surface

/// A power of two, so that rounded coordinates are exact; 0: what is there is too fine to be
/// rounded.
double cellSide(const TriangleMesh& mesh) {
	double side = coarsest;
	for (const auto& t : mesh.triangles.colwise()) {
		const Eigen::Vector3d a = mesh.positions.col(t[1]) - mesh.positions.col(t[0]);
		const Eigen::Vector3d b = mesh.positions.col(t[2]) - mesh.positions.col(t[0]);
		const std::array<double, 3> edges = {a.norm(), b.norm(), (a - b).norm()};
		const auto [shortest, longest] = std::minmax_element(edges.begin(), edges.end());
		side = std::min({side, shareOfEdge * *shortest, shareOfHeight * a.cross(b).norm() / *longest});
	}
	return side < finest * mesh.positions.cwiseAbs().maxCoeff() ? 0 : std::exp2(std::floor(std::log2(side)));
}

Cells cellsOf(const Positions& positions, const Eigen::Matrix3d& turn, double side) {
	const Positions turned = turn * positions;
	Cells cells(positions.cols());
	for (Eigen::Index vertex = 0; vertex < positions.cols(); ++vertex)
		for (int axis = 0; axis < 3; ++axis)
			cells[vertex][axis] = std::llround(turned(axis, vertex) / side);
	return cells;
}

/// What two forms are compared by.
struct Form {
	Cells sorted;                              ///< each cell once
	std::vector<std::array<int, 3>> triangles; ///< numbers of these, the least first, in order

	bool operator<(const Form& other) const {
		return std::tie(sorted, triangles) < std::tie(other.sorted, other.triangles);
	}
};

/// Triangles by their corners' cells, the least first.
/// \param firstCorner  gets for each which of its corners that is
std::vector<std::array<int, 3>> cornersInOrder(const TriangleMesh& mesh, const Cells& cells,
											   const Cells& sorted, std::vector<int>& firstCorner) {
	std::vector<int> rank(cells.size());
	for (std::size_t vertex = 0; vertex < cells.size(); ++vertex)
		rank[vertex] =
			static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), cells[vertex]) - sorted.begin());
	std::vector<std::array<int, 3>> corners;
	firstCorner.clear();
	for (const auto& t : mesh.triangles.colwise()) {
		std::array<int, 3> own = {rank[t[0]], rank[t[1]], rank[t[2]]};
		const auto least = std::min_element(own.begin(), own.end());
		firstCorner.push_back(static_cast<int>(least - own.begin()));
		std::rotate(own.begin(), least, own.end());
		corners.push_back(own);
	}
	return corners;
}

Cells eachOnce(Cells cells) {
	std::sort(cells.begin(), cells.end());
	cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
	return cells;
}

Form formOf(const TriangleMesh& mesh, const Cells& cells) {
	Form form{eachOnce(cells), {}};
	std::vector<int> firstCorner;
	form.triangles = cornersInOrder(mesh, cells, form.sorted, firstCorner);
	std::sort(form.triangles.begin(), form.triangles.end());
	return form;
}

/// The turn whose form is the first.
Eigen::Matrix3d firstOf(const std::vector<Eigen::Matrix3d>& turns, const TriangleMesh& mesh, double side) {
	std::size_t best = 0;
	Form least;
	for (std::size_t i = 0; i < turns.size() && turns.size() > 1; ++i) {
		Form form = formOf(mesh, cellsOf(mesh.positions, turns[i], side));
		if (i == 0 || form < least) {
			least = std::move(form);
			best = i;
		}
	}
	return turns[best];
}

/// Vertices in the order of their cells, copies at one place in that of their first triangles.
std::vector<int> verticesInOrder(const TriangleMesh& mesh, const Cells& cells,
								 const std::vector<int>& triangles) {
	std::vector<int> firstTriangle(cells.size(), 0);
	for (int i = static_cast<int>(triangles.size()); i-- > 0;)
		for (const int vertex : mesh.triangles.col(triangles[i]))
			firstTriangle[vertex] = i;
	std::vector<int> order(cells.size());
	std::iota(order.begin(), order.end(), 0);
	std::sort(order.begin(), order.end(), [&](int a, int b) {
		return std::tie(cells[a], firstTriangle[a], a) < std::tie(cells[b], firstTriangle[b], b);
	});
	return order;
}

} // namespace

CanonicalForm::CanonicalForm(const GivenPatches& given) : given_(given) {
	form_.mesh = given.mesh;
	form_.mesh.singlePrecision = false;
	const AreaMoments moments = areaMoments(given.mesh);
	form_.mesh.positions = (given.mesh.positions.colwise() - moments.centre) / moments.radius();
	const double side = cellSide(form_.mesh);
	if (side > 0) {
		scale_ = moments.radius();
		turn_ = firstOf(candidateAxes(form_.mesh, moments.covariance / (scale_ * scale_)), form_.mesh, side);
		sortAndRound(side);
	} else {
		form_.mesh.positions = given.mesh.positions;
		vertices_.resize(given.mesh.vertexCount());
		std::iota(vertices_.begin(), vertices_.end(), 0);
		triangles_.resize(given.mesh.triangleCount());
		std::iota(triangles_.begin(), triangles_.end(), 0);
		firstCorner_.assign(triangles_.size(), 0);
	}
	numberByThemselves(form_);
	form_.seamLength = inForm(given.seamLength);
}

void CanonicalForm::sortAndRound(double side) {
	TriangleMesh& mesh = form_.mesh;
	const Cells cells = cellsOf(mesh.positions, turn_, side);
	std::vector<int> firstCorner;
	const auto corners = cornersInOrder(mesh, cells, eachOnce(cells), firstCorner);
	triangles_.resize(corners.size());
	std::iota(triangles_.begin(), triangles_.end(), 0);
	std::sort(triangles_.begin(), triangles_.end(),
			  [&](int a, int b) { return std::tie(corners[a], a) < std::tie(corners[b], b); });
	vertices_ = verticesInOrder(mesh, cells, triangles_);
	std::vector<int> number(vertices_.size());
	for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
		number[vertices_[vertex]] = static_cast<int>(vertex);
		for (int axis = 0; axis < 3; ++axis)
			mesh.positions(axis, Eigen::Index(vertex)) = double(cells[vertices_[vertex]][axis]) * side;
	}
	for (std::size_t t = 0; t < triangles_.size(); ++t) {
		firstCorner_.push_back(firstCorner[triangles_[t]]);
		for (int corner = 0; corner < 3; ++corner)
			mesh.triangles(corner, Eigen::Index(t)) =
				number[given_.mesh.triangles((corner + firstCorner_[t]) % 3, triangles_[t])];
		mesh.triangleSelected[t] = given_.mesh.triangleSelected[triangles_[t]];
	}
}

PlannedSurface CanonicalForm::carriedBack(const PlannedSurface& planned) const {
	const TriangleMesh& from = planned.mesh;
	std::vector<int> order(from.triangleCount());
	std::iota(order.begin(), order.end(), 0);
	std::stable_sort(order.begin(), order.end(),
					 [&](int a, int b) { return triangles_[from.face[a]] < triangles_[from.face[b]]; });
	TriangleMesh mesh = from;
	std::vector<int> number(from.vertexCount(), -1), cornerBefore;
	std::copy(vertices_.begin(), vertices_.end(), number.begin());
	int next = static_cast<int>(vertices_.size());
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const int before = order[t], face = from.face[before];
		mesh.face[t] = given_.mesh.face[triangles_[face]];
		mesh.triangleSelected[t] = from.triangleSelected[before];
		for (int corner = 0; corner < 3; ++corner) {
			cornerBefore.push_back(cornerOf(before, (corner + 3 - firstCorner_[face]) % 3));
			int& vertex = number[vertexAt(from, cornerBefore.back())];
			vertex = vertex < 0 ? next++ : vertex;
			mesh.triangles(corner, t) = vertex;
		}
	}
	std::vector<VertexOrigin> origins(from.vertexCount());
	for (int vertex = 0; vertex < from.vertexCount(); ++vertex) {
		const VertexOrigin& origin = planned.origins[vertex];
		const int first = vertices_[origin.first], second = vertices_[origin.second], now = number[vertex];
		mesh.positions.col(now) = pointAt({first, second, origin.share}, given_.mesh.positions);
		origins[now] = {given_.origins[first].first, given_.origins[second].first, origin.share};
	}
	return withPanelsOf(planned.surface, std::move(mesh), std::move(origins), cornerBefore);
}

} // namespace developable::detail
