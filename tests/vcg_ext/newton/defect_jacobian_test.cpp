// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_metric.h"
#include "developable/newton/defect_jacobian.h"
#include "support/finite_differences.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

TEST(DefectJacobian, AgreesWithCentralDifferences) {
	const TriangleMesh left = jitteredGrid(6, 7, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 2 - right.positions.row(0).array();
	TriangleMesh mesh = together(left, right);
	mesh.vertexSelected[9] = 1;
	PatchOptions options;
	options.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, options);
	detail::BendingMetric metric(assembly, {}, 0);
	metric.setSmoothness(Eigen::VectorXd::Constant(2, 1e-3));
	detail::DefectJacobian jacobian(assembly, metric.placeMass());
	jacobian.linearize(assembly.originalPositions);
	Eigen::MatrixXd rows(jacobian.rowCount(), 3 * assembly.placeCount());
	for (int row = 0; row < jacobian.rowCount(); ++row) {
		const Positions gradient = jacobian.applyTransposed(Eigen::VectorXd::Unit(jacobian.rowCount(), row));
		Positions differences = centralDifferences(
			[&](const Positions& p) { return jacobian.scaled(angleDefects(assembly, p))[row]; },
			assembly.originalPositions);
		for (int place = 0; place < assembly.placeCount(); ++place)
			if (assembly.placeFixed[place])
				differences.col(place).setZero();
		EXPECT_LT((gradient - differences).norm(), 1e-6 * differences.norm());
		rows.row(row) = gradient.reshaped().transpose();
	}
	// The other two ways to use the same derivative.
	const Positions displacement = Positions::Random(3, assembly.placeCount());
	EXPECT_LT((jacobian.apply(displacement) - rows * displacement.reshaped()).norm(), 1e-10 * rows.norm());
	const Eigen::VectorXd inverseMass =
		metric.placeMass().cwiseInverse().transpose().replicate(3, 1).reshaped();
	const Eigen::MatrixXd product = rows * inverseMass.asDiagonal() * rows.transpose();
	const Eigen::MatrixXd lower = jacobian.massProduct(0);
	EXPECT_LT((lower - Eigen::MatrixXd(product.triangularView<Eigen::Lower>())).norm(),
			  1e-12 * product.norm());
}

} // namespace
} // namespace developable::test
