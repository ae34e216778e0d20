// SPDX-License-Identifier: GPL-3.0-or-later
// seam_drawing.h: seams as smooth as they may be at each place.
#pragma once

#include "cut_into_panels.h"
#include "memberships.h"
#include "planned_surface.h"
#include "slit_labels.h"

namespace developable::detail {

/// Draws the seams of a plan anew. How smooth they become is chosen triangle by triangle: a seam that follows
/// a smooth curve everywhere may move away from where a panel needs it at one or two places.
class SeamDrawing {
public:
	/// How far seams may move from where triangles of different panels meet.
	enum class Manner {
		Smooth, ///< as they like to
		Taut,   ///< within half an edge
		Safest  ///< as little as can be
	};

	/// At first seams move as little as can be.
	/// \param clusters  per triangle; both sides of any cut differ
	/// \param dartTips  where darts end that no seam shows, whenever it draws; outlives this
	/// \param features  of the plan's surface
	SeamDrawing(const PlannedSurface& planned, const std::vector<int>& clusters,
				const std::vector<Eigen::Vector3d>& dartTips, const CutOptions& options,
				SharpFeatures features);

	/// The same panels, with triangles split where seams cross them if that is asked for.
	PlannedSurface drawn() const;

	/// In the same manner everywhere.
	void draw(Manner manner);

	/// Less smooth near some points, farther round them each time. \return false when there is nothing to be
	/// had
	bool tightenAt(const std::vector<Eigen::Vector3d>& points);

private:
	PlannedSurface relabelled(const Memberships& spread, const std::vector<char>& held) const;
	PlannedSurface splitAlong(const Memberships& spread, const std::vector<char>& held) const;
	void cutDarts(CutSurface& surface, const std::vector<char>& held) const;

	const PlannedSurface& planned_;
	const std::vector<Eigen::Vector3d>& dartTips_;
	const CutOptions options_;
	SlitLabels labels_;
	SharpFeatures features_;
	std::vector<int> tightness_; ///< per triangle
	double radius_ = 0;          ///< of what becomes tighter round a point, length
};

} // namespace developable::detail
