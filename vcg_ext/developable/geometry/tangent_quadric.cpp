// SPDX-License-Identifier: GPL-3.0-or-later
// tangent_quadric.cpp: the normal equations of the fit.
#include "tangent_quadric.h"

#include "vertex_normals.h"

#include "developable/linear/linear.h"

#include <Eigen/Geometry>
#include <limits>

namespace developable::detail {

namespace {

using Square = Eigen::Matrix<double, TangentQuadric::unknowns, TangentQuadric::unknowns>;

/// Of a symmetric matrix, without what is rounding in it.
Square pseudoInverse(const Square& matrix) {
	const SymmetricEigen eigen = symmetricEigen(matrix);
	const double greatest = eigen.values[TangentQuadric::unknowns - 1];
	const double rounding = TangentQuadric::unknowns * std::numeric_limits<double>::epsilon() * greatest;
	Square result = Square::Zero();
	for (int i = 0; i < TangentQuadric::unknowns; ++i)
		if (eigen.values[i] > rounding)
			result += eigen.vectors.col(i) * eigen.vectors.col(i).transpose() / eigen.values[i];
	return result;
}

} // namespace

TangentQuadric::TangentQuadric(const Positions& positions, int place, const Eigen::Vector3d& normal,
							   const std::vector<int>& ring)
	: design_(unknowns, ring.size()) {
	Eigen::Matrix3d frame;
	frame.row(0) = normal.unitOrthogonal();
	frame.row(1) = normal.cross(Eigen::Vector3d(frame.row(0)));
	frame.row(2) = normal;
	Positions points = positions(Eigen::all, ring);
	points.colwise() -= positions.col(place);
	reach_ = points.cwiseAbs().maxCoeff();
	points = (frame * (points / reach_)).eval(); // at most 1, so that no power is small beside rounding
	heights_ = points.row(2);
	const Eigen::Array<double, 1, Eigen::Dynamic> x = points.row(0), y = points.row(1);
	design_ << (x * x).matrix(), (x * y).matrix(), (y * y).matrix(), x.matrix(), y.matrix();
	pseudoInverse_ = pseudoInverse(design_ * design_.transpose());
}

Eigen::Matrix<double, TangentQuadric::unknowns, 1>
TangentQuadric::fitted(const Eigen::RowVectorXd& values) const {
	return pseudoInverse_ * (design_ * values.transpose());
}

Eigen::Matrix<double, TangentQuadric::unknowns, Eigen::Dynamic> TangentQuadric::solution() const {
	return pseudoInverse_ * design_;
}

void visitTangentQuadrics(const PatchAssembly& assembly, const Positions& positions,
						  const TangentQuadricVisitor& visit) {
	const SecondRings rings(assembly);
	const Eigen::Matrix3Xd normals = copyNormals(assembly, positions);
	std::vector<int> ring;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		rings.collect(copy, ring);
		const Eigen::Vector3d normal = normals.col(copy);
		if (static_cast<int>(ring.size()) < TangentQuadric::unknowns || normal.isZero())
			continue;
		for (int& neighbour : ring)
			neighbour = assembly.placeOfCopy[neighbour];
		visit(copy, ring, TangentQuadric(positions, assembly.placeOfCopy[copy], normal, ring));
	}
}

} // namespace developable::detail
