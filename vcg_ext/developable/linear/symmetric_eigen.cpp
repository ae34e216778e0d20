// SPDX-License-Identifier: GPL-3.0-or-later
// symmetric_eigen.cpp: Eigen's iteration.
#include "symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace developable {

SymmetricEigen symmetricEigen(const SmallMatrix& matrix) {
	const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(matrix);
	return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace developable
