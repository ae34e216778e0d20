// SPDX-License-Identifier: GPL-3.0-or-later
// memberships.cpp: the heat equation with cotangent weights.
#include "memberships.h"

#include "developable/linear/linear.h"

#include <cmath>

namespace developable::detail {

namespace {

/// Cotangents are kept within this, so that no weight is negative and none outweighs all others.
constexpr double leastCotangent = 0.05, greatestCotangent = 5;

/// Half edges across which nothing spreads. A seam through a sharp point has to stay there.
std::vector<char> wallsOf(const CutSurface& surface, const std::vector<int>& labels,
						  const Spreading& spreading) {
	const PatchAssembly& assembly = surface.assembly();
	const auto holdsSeam = [&](SharpFeatures::Kind kind, int triangle) {
		return kind == SharpFeatures::Alone ||
			   (kind == SharpFeatures::AmongOthers && spreading.keepsToEverySharpEdge[triangle]);
	};
	const auto isSharp = [&](int h) {
		const int t = triangleOf(h);
		return holdsSeam(spreading.features.edges[h], t) ||
			   holdsSeam(spreading.features.points[surface.startOf(h)], t) ||
			   holdsSeam(spreading.features.points[surface.endOf(h)], t);
	};
	std::vector<char> wall(3 * assembly.triangleCount(), 0);
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int other = assembly.across(h);
		wall[h] = other < 0 ||
				  (labels[triangleOf(h)] != labels[triangleOf(other)] && (isSharp(h) || isSharp(other)));
	}
	return wall;
}

/// The fans between walls, as a number per corner.
Numbering fansBetween(const CutSurface& surface, const std::vector<char>& wall) {
	DisjointSets fans(static_cast<int>(wall.size()));
	for (int h = 0; h < static_cast<int>(wall.size()); ++h) {
		if (wall[h])
			continue;
		const int other = surface.assembly().across(h);
		const bool opposite = surface.startOf(other) == surface.endOf(h);
		fans.unite(h, opposite ? nextCorner(other) : other);
		fans.unite(nextCorner(h), opposite ? other : nextCorner(other));
	}
	return fans.numbering();
}

} // namespace

Memberships memberships(const CutSurface& surface, const std::vector<int>& labels, int labelCount,
						const Spreading& spreading, const std::vector<char>& held) {
	const PatchAssembly& assembly = surface.assembly();
	Memberships result;
	const Numbering fans = fansBetween(surface, wallsOf(surface, labels, spreading));
	result.nodes = fans.count;
	result.triangleNodes =
		Eigen::Map<const Eigen::Matrix3Xi>(fans.number.data(), 3, assembly.triangleCount());
	const double length = meanEdgeLength(assembly);
	const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly, surface.positions());
	std::vector<Eigen::Triplet<double>> entries;
	result.values = Eigen::MatrixXd::Zero(fans.count, labelCount);
	for (int h = 0; h < static_cast<int>(fans.number.size()); ++h) {
		const int t = triangleOf(h), node = fans.number[h], next = fans.number[nextCorner(h)];
		const double opposite = cotangents.data()[previousCorner(h)];
		const double weight = std::pow(spreading.edges[t] * length, 2) / 2 *
							  std::min(std::max(opposite, leastCotangent), greatestCotangent);
		// Triangles that keep their label weigh so much that diffusion can't change it.
		const double mass = surface.areas()[t] / 3 * (!held.empty() && held[t] ? 1e6 : 1);
		entries.emplace_back(node, node, mass + weight);
		entries.emplace_back(next, next, weight);
		entries.emplace_back(std::max(node, next), std::min(node, next), -weight);
		result.values(node, labels[t]) += mass;
	}
	SparseMatrix matrix(fans.count, fans.count);
	matrix.setFromTriplets(entries.begin(), entries.end());
	SparseSolver solver;
	if (solver.factorize(matrix))
		result.values = solver.solve(result.values);
	return result;
}

std::vector<int> mostMembership(const Memberships& memberships) {
	std::vector<int> labels(memberships.triangleNodes.cols());
	for (int t = 0; t < static_cast<int>(labels.size()); ++t)
		memberships.values(memberships.triangleNodes.col(t), Eigen::all).colwise().sum().maxCoeff(&labels[t]);
	return labels;
}

} // namespace developable::detail
