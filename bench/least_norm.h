// SPDX-License-Identifier: GPL-3.0-or-later
// least_norm.h: the least-norm method, which the constrained Newton method is measured beside.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/linear/linear.h"

#include <string>

namespace developable {

/// The derivative of the inner copies' angle defects with respect to the places' coordinates, rows x 3
/// places.
inline SparseMatrix defectJacobian(const PatchAssembly& assembly, const Positions& positions,
								   const std::vector<int>& rowOfCopy, int rows) {
	std::vector<Eigen::Triplet<double>> entries;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const AngleGradients angles(triangleFrame(positions, assembly.trianglePlaces.col(t)));
		for (int corner = 0; corner < 3; ++corner) {
			const int row = rowOfCopy[assembly.triangleCopies(corner, t)];
			for (int vertex = 0; vertex < 3 && row >= 0; ++vertex)
				for (int axis = 0; axis < 3; ++axis)
					entries.emplace_back(row, 3 * assembly.trianglePlaces(vertex, t) + axis,
										 -angles.of(corner, vertex)[axis]);
		}
	}
	SparseMatrix jacobian(rows, 3 * assembly.placeCount());
	jacobian.setFromTriplets(entries.begin(), entries.end());
	return jacobian;
}

/// Wang 2008 (Computing length-preserved free boundary for quasi-developable mesh segmentation): full
/// least-norm steps −Jᵀ(JJᵀ)⁻¹g with three unknowns a vertex.
/// \return  how it ended
inline std::string leastNorm(const PatchAssembly& assembly, Positions& positions) {
	std::vector<int> rowOfCopy(assembly.copyCount(), -1), copies;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (assembly.copyInterior[copy]) {
			rowOfCopy[copy] = static_cast<int>(copies.size());
			copies.push_back(copy);
		}
	SparseCholesky factorization;
	for (int step = 0; step < 60; ++step) {
		const Eigen::VectorXd defects = angleDefects(assembly, positions);
		if (!defects.allFinite() || defects.cwiseAbs().sum() < 1e-6)
			break;
		const SparseMatrix jacobian =
			defectJacobian(assembly, positions, rowOfCopy, static_cast<int>(copies.size()));
		SparseMatrix product = jacobian * jacobian.transpose();
		product.diagonal().array() += 1e-12 * product.diagonal().mean();
		if (!factorization.factorize(product))
			return "not positive definite";
		const Eigen::VectorXd wanted = defects(copies);
		const Eigen::VectorXd move = jacobian.transpose() * factorization.solve(wanted);
		positions.reshaped() -= move;
	}
	return "done";
}

} // namespace developable
