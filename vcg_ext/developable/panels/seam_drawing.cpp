// SPDX-License-Identifier: GPL-3.0-or-later
// seam_drawing.cpp: labels spread, seams where two of them are equal.
#include "seam_drawing.h"

#include "relief_darts.h"
#include "selected_whole.h"
#include "smooth_seams.h"
#include "taut_curves.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace developable::detail {

namespace {

/// How seams may be drawn, from smooth to safe.
struct Tightness {
	double edges; ///< how far labels spread, in mean edge lengths
	bool keepsToEverySharpEdge;
	bool taut;
};

constexpr Tightness levels[] = {
	{1.5, false, true}, {0.7, false, true}, {0.7, true, true}, {0.7, true, false}};
constexpr int safest = 3;
/// Mean edge lengths round a point where seams become tighter, at first and from time to time.
constexpr double firstRadius = 4, growth = 1.25;
constexpr double transition = 1.5; ///< of that radius, beyond which nothing changes

/// The panel of the triangle whose middle is nearest.
int panelAt(const CutSurface& surface, const Eigen::Vector3d& point) {
	int nearest = 0;
	double least = std::numeric_limits<double>::infinity();
	for (int t = 0; t < surface.assembly().triangleCount(); ++t) {
		const Eigen::Vector3d middle = surface.barycentre(t);
		if ((middle - point).squaredNorm() < least) {
			least = (middle - point).squaredNorm();
			nearest = t;
		}
	}
	return surface.panelOf(nearest);
}

} // namespace

SeamDrawing::SeamDrawing(const PlannedSurface& planned, const std::vector<int>& clusters,
						 const std::vector<Eigen::Vector3d>& dartTips, const CutOptions& options,
						 SharpFeatures features)
	: planned_(planned), dartTips_(dartTips), options_(options), labels_(planned.surface, clusters),
	  features_(std::move(features)), tightness_(planned.surface.assembly().triangleCount(), safest) {}

void SeamDrawing::draw(Manner manner) {
	const int level = manner == Manner::Smooth ? 0 : manner == Manner::Taut ? safest - 1 : safest;
	std::fill(tightness_.begin(), tightness_.end(), level);
	radius_ = firstRadius * meanEdgeLength(planned_.surface.assembly());
}

bool SeamDrawing::tightenAt(const std::vector<Eigen::Vector3d>& points) {
	bool any = false;
	for (const double diagonal = boxDiagonal(planned_.surface.positions()); !any && radius_ < diagonal;
		 radius_ *= growth)
		for (int t = 0; t < static_cast<int>(tightness_.size()); ++t) {
			const Eigen::Vector3d middle = planned_.surface.middleOf(3 * t);
			for (const Eigen::Vector3d& point : points) {
				const double distance = (point - middle).norm() / radius_;
				const int least = distance < 1 ? safest : distance < transition ? safest - 1 : 0;
				any = any || least > tightness_[t];
				tightness_[t] = std::max(tightness_[t], least);
			}
		}
	return any;
}

PlannedSurface SeamDrawing::drawn() const {
	Spreading spreading{features_, {}, {}};
	for (const int tightness : tightness_) {
		spreading.edges.push_back(levels[tightness].edges);
		spreading.keepsToEverySharpEdge.push_back(levels[tightness].keepsToEverySharpEdge);
	}
	const std::vector<char> held = keptTriangles(planned_, options_);
	const Memberships spread =
		memberships(planned_.surface, labels_.labels(), labels_.count(), spreading, held);
	return options_.splitTriangles ? splitAlong(spread, held) : relabelled(spread, held);
}

void SeamDrawing::cutDarts(CutSurface& surface, const std::vector<char>& held) const {
	for (const Eigen::Vector3d& tip : dartTips_)
		cutDart(surface, panelAt(surface, tip), tip, 0, held);
}

/// Seams between the same two panels, or the slit of one, need clusters as labels: these say which chains of
/// the new seams go.
PlannedSurface SeamDrawing::relabelled(const Memberships& spread, const std::vector<char>& held) const {
	PlannedSurface result = planned_;
	const std::vector<int> labels =
		result.surface.withoutFragments(withSelectedWhole(planned_, options_, mostMembership(spread)));
	result.surface.relabel(labels);
	labels_.openWithin(result.surface, labels);
	cutDarts(result.surface, held);
	return result;
}

PlannedSurface SeamDrawing::splitAlong(const Memberships& spread, const std::vector<char>& held) const {
	SplitMesh split = splitAlongSeams(planned_.mesh, planned_.surface, spread);
	CutSurface surface(assemblePatches(split.mesh, {}));
	const std::vector<int> labels = surface.withoutFragments(split.labels);
	surface.relabel(labels);
	labels_.openWithin(surface, labels);
	std::vector<char> heldParts;
	for (std::size_t i = 0; i < split.mesh.face.size() && !held.empty(); ++i)
		heldParts.push_back(held[split.mesh.face[i]]);
	cutDarts(surface, heldParts);
	DrawnSeams drawn{std::move(split), std::move(surface)};
	std::vector<char> stays;
	for (const int tightness : tightness_)
		stays.push_back(!levels[tightness].taut);
	if (std::find(stays.begin(), stays.end(), 0) != stays.end())
		drawn = pulledTaut(std::move(drawn), planned_, features_, {held, stays});
	for (VertexOrigin& origin : drawn.split.origins)
		origin = {planned_.origins[origin.first].first, planned_.origins[origin.second].first, origin.share};
	for (int& face : drawn.split.mesh.face)
		face = planned_.mesh.face[face];
	return {std::move(drawn.split.mesh), std::move(drawn.split.origins), std::move(drawn.surface)};
}

} // namespace developable::detail
