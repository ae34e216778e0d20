// SPDX-License-Identifier: GPL-3.0-or-later
// patch_measures.cpp: one pass over all vertex copies.
#include "patch_measures.h"

#include "angle_defect.h"

namespace developable {

std::vector<PatchMeasures> measurePatches(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<PatchMeasures> measures(assembly.patchCount());
	for (int patch = 0; patch < assembly.patchCount(); ++patch)
		measures[patch].faces = assembly.patches[patch].triangles;
	std::vector<char> seen(assembly.patchCount(), 0);
	const Eigen::VectorXd defects = angleDefects(assembly, positions);
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int patch = assembly.patchOfCopy[copy], place = assembly.placeOfCopy[copy];
		PatchMeasures& ofPatch = measures[patch];
		const double defect = std::abs(defects[copy]);
		const double moved = (positions.col(place) - assembly.originalPositions.col(place)).norm();
		ofPatch.curvature += defect;
		ofPatch.meanDisplacement += moved / assembly.patches[patch].copies;
		ofPatch.maxDisplacement = std::max(ofPatch.maxDisplacement, moved);
		if (!seen[patch] || defect > ofPatch.maxAngleDefect) {
			ofPatch.maxAngleDefect = defect;
			ofPatch.worstPoint = positions.col(place);
			seen[patch] = 1;
		}
	}
	return measures;
}

} // namespace developable
