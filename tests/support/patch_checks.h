// SPDX-License-Identifier: GPL-3.0-or-later
// patch_checks.h: what tests ask of an assembly: its numbers, its angle defects, and why a mesh was refused.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace developable::test {

/// The place of a point, or -1.
inline int placeAt(const PatchAssembly& assembly, const Eigen::Vector3d& point) {
	for (int place = 0; place < assembly.placeCount(); ++place)
		if ((assembly.originalPositions.col(place) - point).norm() < 1e-12)
			return place;
	return -1;
}

/// g of every copy at a place, inside its patch or not, ascending.
inline std::vector<double> defectsAt(const PatchAssembly& assembly, int place) {
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	std::vector<double> result;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.placeOfCopy[copy] == place)
			result.push_back(defects[copy]);
	std::sort(result.begin(), result.end());
	return result;
}

inline void expectDefects(const PatchAssembly& assembly, const Eigen::Vector3d& point,
						  std::vector<double> expected) {
	const int place = placeAt(assembly, point);
	ASSERT_GE(place, 0);
	const std::vector<double> defects = defectsAt(assembly, place);
	std::sort(expected.begin(), expected.end());
	ASSERT_EQ(defects.size(), expected.size()) << "at " << point.transpose();
	for (std::size_t i = 0; i < expected.size(); ++i)
		EXPECT_NEAR(defects[i], expected[i], 1e-13) << "at " << point.transpose();
	EXPECT_EQ(assembly.placeAssembling[place], expected.size() > 1);
}

inline void expectCounts(const PatchAssembly& assembly, int patches, int places, int copies, int assembling) {
	EXPECT_EQ(assembly.patchCount(), patches);
	EXPECT_EQ(assembly.placeCount(), places);
	EXPECT_EQ(assembly.copyCount(), copies);
	EXPECT_EQ(assembly.assemblingPlaceCount(), assembling);
}

/// What an exception of the given type says.
template <class Exception, class Function>
std::string messageOf(const Function& function) {
	try {
		function();
	} catch (const Exception& exception) {
		return exception.what();
	}
	ADD_FAILURE() << "nothing was thrown";
	return {};
}

template <class Exception>
std::string refusal(const TriangleMesh& mesh, const PatchOptions& options = {}) {
	return messageOf<Exception>([&] { assemblePatches(mesh, options); });
}

inline PatchOptions welding(double distance) {
	PatchOptions options;
	options.weldDistance = distance;
	return options;
}

inline PatchOptions selectedOnly(double weldDistance = 0) {
	PatchOptions options = welding(weldDistance);
	options.onlySelected = true;
	return options;
}

} // namespace developable::test
