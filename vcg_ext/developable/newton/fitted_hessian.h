// SPDX-License-Identifier: GPL-3.0-or-later
// fitted_hessian.h: the second derivatives of a function on a triangulated surface, and how much it bends.
#pragma once

#include "developable/mesh/mesh.h"

#include <vector>

namespace developable::detail {

/// ∫|f''|² over one triangle, as the squared lengths of linear functions of f's values.
struct TriangleBending {
	/// Where the values are taken; a place can be there more than once.
	std::vector<int> places;
	/// Rows x places: the energy is the squared norm of this matrix times the values at the places, without
	/// unit where f is a length.
	Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows;
	bool determined = true; ///< a quadratic function is told from its values there
};

/// The bending of a function f whose values are given at the places.
///
/// A hinge, two triangles with a common edge e, tells one number: K_e f, the jump of the slope of f across
/// the edge times its length (Bergou et al. 2006, A Quadratic Bending Model for Inextensible Surfaces,
/// Section 3). For a quadratic f it is a known linear function of its Hessian, K_e f = ⟨C_e, f''⟩. So the
/// Hessian H of a triangle is fitted to the hinges round it, which are unfolded into its plane: least squares
/// of (K_e f − ⟨C_e, H⟩) / |C_e|. Its own three hinges, which are six points, most often are enough; where
/// they all but lie on a conic, or where a border takes some away, those of its neighbours, and theirs, are
/// added. The energy is
///
///     A |H|² + Σ_e γ (K_e f − ⟨C_e, H⟩)² / (A_1 + A_2),    e: its own hinges,
///
/// so it is exact for quadratic functions on any triangulation of the plane that determines them (the patch
/// test), as a Morley element's is, with values at vertices only; it has no zero but affine functions,
/// because the second term holds what no quadratic explains (as in virtual elements, Beirão da Veiga et al.
/// 2013). Where nothing determines a quadratic, as on a strip of triangles, H is the smallest that fits.
class FittedHessian {
public:
	/// \param areas  of the triangles
	FittedHessian(const PatchAssembly& assembly, const Eigen::VectorXd& areas);

	/// A triangle without neighbours does not bend and has no rows.
	TriangleBending bending(int triangle) const;

private:
	const PatchAssembly& assembly_;
	const Eigen::VectorXd& areas_;
};

} // namespace developable::detail
