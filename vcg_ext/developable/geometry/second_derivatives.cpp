// SPDX-License-Identifier: GPL-3.0-or-later
// second_derivatives.cpp: rows of fitted quadrics.
#include "second_derivatives.h"

#include "tangent_quadric.h"
#include "vertex_normals.h"

#include <cmath>

namespace developable {

std::vector<SecondDerivatives> secondDerivatives(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<SecondDerivatives> result(assembly.copyCount());
	const detail::SecondRings rings(assembly);
	const Eigen::Matrix3Xd normals = copyNormals(assembly, positions);
	std::vector<int> ring;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		rings.collect(copy, ring);
		const Eigen::Vector3d normal = normals.col(copy);
		if (static_cast<int>(ring.size()) < detail::TangentQuadric::unknowns || normal.isZero())
			continue;
		for (int& neighbour : ring)
			neighbour = assembly.placeOfCopy[neighbour];
		const int place = assembly.placeOfCopy[copy];
		const detail::TangentQuadric quadric(positions, place, normal, ring);
		const Eigen::MatrixXd solution = quadric.solution();
		if (!solution.allFinite())
			continue;
		Eigen::Matrix3Xd rows(3, solution.cols() + 1);
		rows.rightCols(solution.cols()) << 2 * solution.row(0), std::sqrt(2.0) * solution.row(1),
			2 * solution.row(2);
		rows.col(0) = -rows.rightCols(solution.cols()).rowwise().sum();
		result[copy].rows = rows / (quadric.reach() * quadric.reach());
		result[copy].places = {place};
		result[copy].places.insert(result[copy].places.end(), ring.begin(), ring.end());
	}
	return result;
}

} // namespace developable
