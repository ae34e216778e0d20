// SPDX-License-Identifier: GPL-3.0-or-later
// without_detail.cpp: steps of smoothing, while each does much at little cost.
#include "without_detail.h"

#include "bending_matrix.h"
#include "developable/geometry/geometry.h"
#include "soundness.h"
#include "unfairness.h"

#include <cmath>

namespace developable {

namespace {

/// By one step, in which triangles that it would spoil move as one piece.
PatchAssembly withoutShortWaves(const PatchAssembly& original, double wavelength, const NewtonTuning& tuning,
								double memoryLimit) {
	const Positions& positions = original.originalPositions;
	const double fairness = wavelength / std::sqrt(detail::triangleAreas(original, positions).sum());
	const detail::Unfairness unfairness(original, detail::shapeSmoothness(fairness), tuning, memoryLimit);
	PatchAssembly smoothed = original;
	Positions move = unfairness.step(positions).move;
	if (detail::Soundness(original, tuning).spare(positions, move))
		smoothed.originalPositions += move;
	return smoothed;
}

double curvature(const PatchAssembly& assembly) {
	return totalAbsoluteCurvature(angleDefects(assembly, assembly.originalPositions));
}

double rootMeanSquareMove(const PatchAssembly& original, const PatchAssembly& smoothed) {
	const Positions move = smoothed.originalPositions - original.originalPositions;
	return move.norm() / std::sqrt(double(original.placeCount()));
}

/// Whether moves along the normals are not alike at both ends of edges: else it is features that become
/// smaller.
bool isDetail(const PatchAssembly& before, const PatchAssembly& smoothed, const NewtonTuning& tuning) {
	const Eigen::Matrix3Xd normals = placeNormals(smoothed, smoothed.originalPositions);
	const Positions move = smoothed.originalPositions - before.originalPositions;
	const Positions along = normals * move.cwiseProduct(normals).colwise().sum().asDiagonal();
	double both = 0, each = 0;
	for (const auto& ends : before.edgePlaces.colwise()) {
		both += along.col(ends[0]).dot(along.col(ends[1]));
		each += (along.col(ends[0]).squaredNorm() + along.col(ends[1]).squaredNorm()) / 2;
	}
	return both <= tuning.detailLikeness * each;
}

} // namespace

std::optional<PatchAssembly> withoutDetail(const PatchAssembly& original, double farthest,
										   const NewtonTuning& tuning, double memoryLimit) {
	const double wavelength = tuning.detailWave * meanEdgeLength(original);
	std::optional<PatchAssembly> result;
	for (int step = 0; step < tuning.detailSteps; ++step) {
		const PatchAssembly& before = result ? *result : original;
		PatchAssembly smoothed = withoutShortWaves(before, wavelength, tuning, memoryLimit);
		if (curvature(smoothed) >= tuning.detailCurvature * curvature(before) ||
			rootMeanSquareMove(original, smoothed) > tuning.detailMove * farthest ||
			!isDetail(before, smoothed, tuning))
			break;
		result = std::move(smoothed);
	}
	return result;
}

double roomOfDetail(const PatchAssembly& original, const PatchAssembly& smoothed) {
	constexpr double most = 2; // nearly all places were moved by less
	return most * rootMeanSquareMove(original, smoothed);
}

} // namespace developable
