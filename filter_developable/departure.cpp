// SPDX-License-Identifier: GPL-3.0-or-later
// departure.cpp: displacement, folds and areas against the original.
#include "departure.h"

#include "developable/geometry/geometry.h"

#include <algorithm>

namespace developable::plugin {

namespace {

int countFolded(const PatchAssembly& assembly, const Eigen::Matrix3Xd& before,
				const Eigen::Matrix3Xd& after) {
	std::vector<char> folded(std::size_t(assembly.triangleCount()), 0);
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.across(halfEdge);
		if (across < 0)
			continue;
		const int one = halfEdge / 3, other = across / 3;
		const double product = after.col(one).dot(after.col(other));
		if (before.col(one).dot(before.col(other)) > 0 &&
			product < -0.5 * after.col(one).norm() * after.col(other).norm())
			folded[std::size_t(one)] = folded[std::size_t(other)] = 1;
	}
	return static_cast<int>(std::count(folded.begin(), folded.end(), 1));
}

int countShrunken(const PatchAssembly& assembly, const Eigen::Matrix3Xd& before,
				  const Eigen::Matrix3Xd& after) {
	Eigen::ArrayXd areas = Eigen::ArrayXd::Zero(assembly.patchCount()), areasAfter = areas;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		areas[assembly.patchOfTriangle[std::size_t(t)]] += before.col(t).norm();
		areasAfter[assembly.patchOfTriangle[std::size_t(t)]] += after.col(t).norm();
	}
	return static_cast<int>((areasAfter < 0.5 * areas).count());
}

double numberOf(const Result& result) {
	return std::visit([](auto value) { return static_cast<double>(value); }, result.value);
}

void addDeparture(Results& results, const PatchAssembly& assembly, const Positions& positions) {
	const Eigen::Matrix3Xd before = areaNormals(assembly, assembly.originalPositions),
						   after = areaNormals(assembly, positions);
	results.push_back({"folded_faces", countFolded(assembly, before, after), ""});
	results.push_back({"shrunken_patches", countShrunken(assembly, before, after), ""});
}

} // namespace

double farthestInPerCent(const PatchAssembly& assembly, const Positions& positions) {
	double farthest = 0;
	for (const AssemblyPart& part : partsOf(assembly)) {
		const Positions& original = part.assembly.originalPositions;
		const double diagonal = boxDiagonal(original);
		const double moved = displacementMap(original, positions(Eigen::all, part.wholePlace)).maxCoeff();
		if (diagonal > 0)
			farthest = std::max(farthest, 100 * moved / diagonal);
	}
	return farthest;
}

void logWarnings(const FilterCall& call, const Results& results) {
	for (const Warning& warning : departureWarnings)
		for (const Result& result : results)
			if (result.key == warning.key && numberOf(result) > warning.limit)
				call.log("warning: " + filledIn(warning.text, results));
}

void logDepartures(const FilterCall& call, Results results, const PatchAssembly& assembly,
				   const Positions& positions) {
	addDeparture(results, assembly, positions);
	logWarnings(call, results);
}

} // namespace developable::plugin
