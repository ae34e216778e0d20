// SPDX-License-Identifier: GPL-3.0-or-later
// tangent_quadric.cpp: the normal equations of the fit.
#include "tangent_quadric.h"

#include "vertex_normals.h"

#include <Eigen/Geometry>

namespace developable::detail {

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
	decomposition_.compute(design_ * design_.transpose());
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
