// SPDX-License-Identifier: GPL-3.0-or-later
// second_derivatives.cpp: rows of fitted quadrics.
#include "second_derivatives.h"

#include "tangent_quadric.h"

#include <cmath>

namespace developable {

std::vector<SecondDerivatives> secondDerivatives(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<SecondDerivatives> result(assembly.copyCount());
	const auto add = [&](int copy, const std::vector<int>& ring, const detail::TangentQuadric& quadric) {
		const Eigen::MatrixXd solution = quadric.solution();
		if (!solution.allFinite())
			return;
		Eigen::Matrix3Xd rows(3, solution.cols() + 1);
		rows.rightCols(solution.cols()) << 2 * solution.row(0), std::sqrt(2.0) * solution.row(1),
			2 * solution.row(2);
		rows.col(0) = -rows.rightCols(solution.cols()).rowwise().sum();
		result[copy].rows = rows / (quadric.reach() * quadric.reach());
		result[copy].places = {assembly.placeOfCopy[copy]};
		result[copy].places.insert(result[copy].places.end(), ring.begin(), ring.end());
	};
	detail::visitTangentQuadrics(assembly, positions, add);
	return result;
}

} // namespace developable
