// SPDX-License-Identifier: GPL-3.0-or-later
// symmetric_eigen.h: eigenvalues and eigenvectors of small symmetric matrices, compiled once for all sizes.
#pragma once

#include <Eigen/Core>

namespace developable {

constexpr int mostSymmetricRows = 6;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostSymmetricRows,
								  mostSymmetricRows>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostSymmetricRows, 1>;

struct SymmetricEigen {
	SmallVector values;  ///< ascending
	SmallMatrix vectors; ///< a unit vector each, in columns
};

/// \param matrix  symmetric, of up to six rows; only its lower triangle is read
SymmetricEigen symmetricEigen(const SmallMatrix& matrix);

} // namespace developable
