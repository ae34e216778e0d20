// SPDX-License-Identifier: GPL-3.0-or-later
// area_hessian.h: second derivatives of what depends on a flat triangle's area.
#pragma once

#include <Eigen/Core>

namespace developable::detail {

using AreaGradient = Eigen::Matrix<double, 6, 1>; ///< of the doubled area A by the corners, x and y of each
using AreaHessian = Eigen::Matrix<double, 6, 6>;

/// f'' ∇A ∇Aᵀ + f' ∇²A, the Hessian of f(A).
/// \param slope, curvature  f' and f''
AreaHessian areaHessian(const AreaGradient& area, double slope, double curvature);

/// The nearest positive semidefinite matrix, in closed form: ∇²A has the eigenvalues √3, −√3 and 0, each
/// twice, with the triangles that are equilateral either way round as eigenvectors.
/// \param slope      f' ≤ 0
/// \param curvature  f'' ≥ 0
AreaHessian convexAreaHessian(const AreaGradient& area, double slope, double curvature);

} // namespace developable::detail
