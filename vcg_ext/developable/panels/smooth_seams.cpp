// SPDX-License-Identifier: GPL-3.0-or-later
// smooth_seams.cpp: crossings on edges, then triangles in two, three or four.
#include "smooth_seams.h"

#include <algorithm>
#include <map>
#include <set>

namespace developable::detail {

namespace {

/// Nearer to a vertex than this share of the edge, a crossing goes to it: slivers are no good.
constexpr double nearVertex = 0.22;

class SeamSplitter {
public:
	SeamSplitter(const TriangleMesh& mesh, const CutSurface& surface, const Memberships& memberships)
		: mesh_(mesh), surface_(surface), memberships_(memberships), labelsAt_(memberships.nodes),
		  crossing_(3 * mesh.triangleCount(), -1) {
		result_.mesh.leastHeightRatio = mesh.leastHeightRatio;
		result_.mesh.lengthExponent = mesh.lengthExponent;
		for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
			result_.origins.push_back({vertex, vertex, 0});
	}

	SplitMesh split() {
		for (int node = 0; node < memberships_.nodes; ++node)
			labelsAt_[node] = {labelOf(node)};
		findSewnSides();
		for (int h = 0; h < static_cast<int>(crossing_.size()); ++h)
			goToNearVertex(h);
		for (int h = 0; h < static_cast<int>(crossing_.size()); ++h)
			cross(h);
		for (int t = 0; t < mesh_.triangleCount(); ++t)
			splitTriangle(t);
		finish();
		return std::move(result_);
	}

private:
	int nodeAt(int corner) const { return memberships_.triangleNodes.data()[corner]; }

	int labelOf(int node) const {
		Eigen::Index most = 0;
		memberships_.values.row(node).maxCoeff(&most);
		return static_cast<int>(most);
	}

	/// Where along a half edge its ends' labels are equal, 0 to 1; negative when they have one in common.
	double crossingAlong(int h) const {
		const int a = nodeAt(h), b = nodeAt(nextCorner(h));
		const int i = labelOf(a), j = labelOf(b);
		if (i == j)
			return -1;
		const double before = memberships_.values(a, i) - memberships_.values(a, j);
		const double after = memberships_.values(b, j) - memberships_.values(b, i);
		return before + after > 0 ? before / (before + after) : 0.5;
	}

	void goToNearVertex(int h) {
		const double share = crossingAlong(h);
		const double nearest = sewn_[h] ? 0.5 : nearVertex; // a side that is sewn to another stays whole
		if (share < 0 || (share > nearest && share < 1 - nearest))
			return;
		const int a = nodeAt(h), b = nodeAt(nextCorner(h));
		const int near = share <= nearest ? a : b, far = share <= nearest ? b : a;
		labelsAt_[near].insert(labelOf(far));
	}

	/// Sides of patches that are sewn to others, or to themselves.
	void findSewnSides() {
		const PatchAssembly& assembly = surface_.assembly();
		std::map<std::pair<int, int>, int> borders;
		const auto ends =
			[&](int h) -> std::pair<int, int> { // values: std::minmax refers to what it is given
			return std::minmax(assembly.placeAt(h), assembly.placeAt(nextCorner(h)));
		};
		sewn_.assign(crossing_.size(), 0);
		for (const bool counting : {true, false})
			for (int h = 0; h < static_cast<int>(crossing_.size()); ++h)
				if (assembly.across(h) < 0) {
					int& sides = borders[ends(h)];
					sides += counting;
					sewn_[h] = !counting && sides > 1;
				}
	}

	bool haveInCommon(int a, int b) const {
		return std::any_of(labelsAt_[a].begin(), labelsAt_[a].end(),
						   [&](int label) { return labelsAt_[b].count(label) > 0; });
	}

	/// A new vertex where no label is common to both ends of an edge.
	void cross(int h) {
		const int other = surface_.assembly().across(h), a = nodeAt(h), b = nodeAt(nextCorner(h));
		if (crossing_[h] >= 0 || haveInCommon(a, b))
			return;
		const double share = std::min(std::max(crossingAlong(h), nearVertex), 1 - nearVertex);
		crossing_[h] = static_cast<int>(result_.origins.size());
		result_.origins.push_back({vertexAt(mesh_, h), vertexAt(mesh_, nextCorner(h)), share});
		if (other >= 0)
			crossing_[other] = crossing_[h];
	}

	/// With how much of each label a vertex of the result counts when a triangle's label is chosen.
	Eigen::RowVectorXd membershipAt(int corner, bool crossing) const {
		const int a = nodeAt(corner), b = nodeAt(nextCorner(corner));
		Eigen::RowVectorXd of = Eigen::RowVectorXd::Zero(memberships_.values.cols());
		for (const int label : labelsAt_[a])
			of[label] = 1;
		if (crossing)
			for (const int label : labelsAt_[b])
				of[label] = 1;
		return of;
	}

	void add(int triangle, const std::array<int, 3>& vertices, const Eigen::RowVectorXd& votes) {
		triangles_.push_back({vertices[0], vertices[1], vertices[2]});
		result_.mesh.face.push_back(triangle);
		// What most of the corners may have; of those, what the triangle has most of.
		const Eigen::RowVectorXd most =
			memberships_.values(memberships_.triangleNodes.col(triangle), Eigen::all).colwise().sum();
		int label = 0;
		(votes + most / 4).maxCoeff(&label);
		result_.labels.push_back(label);
	}

	void splitTriangle(int t) {
		std::vector<int> crossed;
		for (int h = 3 * t; h < 3 * t + 3; ++h)
			if (crossing_[h] >= 0)
				crossed.push_back(h);
		const auto corner = [&](int h) { return vertexAt(mesh_, h); };
		const auto at = [&](int h) { return membershipAt(h, false); };
		const auto middle = [&](int h) { return membershipAt(h, true); };
		if (crossed.empty()) {
			const int h = 3 * t;
			add(t, {corner(h), corner(h + 1), corner(h + 2)}, at(h) + at(h + 1) + at(h + 2));
		} else if (crossed.size() == 1) {
			const int h = crossed[0], n = nextCorner(h), p = previousCorner(h), m = crossing_[h];
			add(t, {corner(h), m, corner(p)}, at(h) + middle(h) + at(p));
			add(t, {m, corner(n), corner(p)}, middle(h) + at(n) + at(p));
		} else if (crossed.size() == 2) {
			splitOffCorner(t);
		} else {
			for (int h = 3 * t; h < 3 * t + 3; ++h)
				add(t, {corner(h), crossing_[h], crossing_[previousCorner(h)]}, 3 * at(h));
			const int h = 3 * t;
			add(t, {crossing_[h], crossing_[h + 1], crossing_[h + 2]}, 0 * at(h));
		}
	}

	/// Two sides are crossed: the corner between them comes off, and the rest is two triangles.
	void splitOffCorner(int t) {
		int top = 3 * t; // the corner between the sides that are crossed
		while (crossing_[top] < 0 || crossing_[previousCorner(top)] < 0)
			++top;
		const int n = nextCorner(top), p = previousCorner(top);
		const int right = crossing_[top], left = crossing_[p];
		const auto corner = [&](int h) { return vertexAt(mesh_, h); };
		add(t, {corner(top), right, left}, 3 * membershipAt(top, false));
		const Eigen::RowVectorXd rest = membershipAt(n, false) + membershipAt(p, false);
		const double first = (pointOf(right) - pointOf(corner(p))).norm();
		const double second = (pointOf(left) - pointOf(corner(n))).norm();
		if (first < second) {
			add(t, {right, corner(n), corner(p)}, rest);
			add(t, {right, corner(p), left}, rest);
		} else {
			add(t, {right, corner(n), left}, rest);
			add(t, {left, corner(n), corner(p)}, rest);
		}
	}

	Eigen::Vector3d pointOf(int vertex) const { return pointAt(result_.origins[vertex], mesh_.positions); }

	void finish() {
		TriangleMesh& mesh = result_.mesh;
		mesh.positions.resize(3, result_.origins.size());
		for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
			mesh.positions.col(vertex) = pointOf(vertex);
		mesh.triangles.resize(3, triangles_.size());
		for (int t = 0; t < mesh.triangleCount(); ++t)
			mesh.triangles.col(t) = triangles_[t];
		mesh.vertexSelected.assign(mesh.vertexCount(), 0);
		mesh.triangleSelected.resize(triangles_.size());
		for (int t = 0; t < mesh.triangleCount(); ++t)
			mesh.triangleSelected[t] = mesh_.triangleSelected[mesh.face[t]];
	}

	const TriangleMesh& mesh_;
	const CutSurface& surface_;
	const Memberships& memberships_;
	std::vector<std::set<int>> labelsAt_; // of each node; several where a curve goes through it
	std::vector<int> crossing_;           // per half edge the new vertex on it, or -1
	std::vector<char> sewn_;              // per half edge
	std::vector<Eigen::Vector3i> triangles_;
	SplitMesh result_;
};

} // namespace

SplitMesh splitAlongSeams(const TriangleMesh& mesh, const CutSurface& surface,
						  const Memberships& memberships) {
	return SeamSplitter(mesh, surface, memberships).split();
}

} // namespace developable::detail
