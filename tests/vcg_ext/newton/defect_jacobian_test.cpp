// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_metric.h"
#include "developable/newton/defect_jacobian.h"
#include "support/corkscrew.h"
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
	metric.setSmoothness({Eigen::VectorXd::Constant(2, 1e-3)});
	detail::DefectJacobian jacobian(assembly, metric.placeMass(), 0.02);
	const Positions shape = assembly.originalPositions + 0.02 * Positions::Random(3, assembly.placeCount());
	jacobian.linearize(shape);
	ASSERT_GT((jacobian.scaled(flatDefects(assembly, shape), shape).tail(20).array() != 0).count(),
			  10); // borders turn
	Eigen::MatrixXd rows(jacobian.rowCount(), 3 * assembly.placeCount());
	for (int row = 0; row < jacobian.rowCount(); ++row) {
		const Positions gradient = jacobian.applyTransposed(Eigen::VectorXd::Unit(jacobian.rowCount(), row));
		Positions differences = centralDifferences(
			[&](const Positions& p) { return jacobian.scaled(flatDefects(assembly, p), p)[row]; }, shape);
		for (int place = 0; place < assembly.placeCount(); ++place)
			if (assembly.placeFixed[place])
				differences.col(place).setZero();
		EXPECT_LE((gradient - differences).norm(), 1e-5 * differences.norm());
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

TEST(DefectJacobian, SeesABorderThatOverlapsItself) {
	for (const double angle : {6.0, 6.6}) {
		const PatchAssembly assembly = assembled(corkscrew(angle));
		const Positions& shape = assembly.originalPositions;
		detail::DefectJacobian jacobian(assembly, detail::placeMasses(assembly), 0.1);
		jacobian.linearize(shape);
		const auto first = [&](const Positions& p) {
			return jacobian.scaled(flatDefects(assembly, p), p)[0];
		};
		EXPECT_EQ(first(shape) < 0, borderAngles(assembly, shape).maxCoeff() > 2 * pi);
		const Positions gradient = jacobian.applyTransposed(Eigen::VectorXd::Unit(jacobian.rowCount(), 0));
		const Positions differences = centralDifferences(first, shape);
		EXPECT_LE((gradient - differences).norm(), 1e-5 * differences.norm());
		EXPECT_EQ(gradient.norm() > 0, angle > 6.3);
	}
}

TEST(DefectJacobian, SeesABorderThatComesToOverlapItself) {
	const PatchAssembly assembly = assembled(corkscrew(4));
	const Positions shape = corkscrew(6.6).positions;
	detail::DefectJacobian jacobian(assembly, detail::placeMasses(assembly), 0.1);
	jacobian.linearize(shape);
	EXPECT_GT(jacobian.scaled(flatDefects(assembly, shape), shape).head(1).norm(), 0.1);
	EXPECT_GT(jacobian.applyTransposed(Eigen::VectorXd::Unit(jacobian.rowCount(), 0)).norm(), 0);
}

TEST(DefectJacobian, ForeseesWhichBordersAStepWouldBend) {
	const PatchAssembly assembly = assembled(grid(5, 5, flatSheet));
	const Positions& flat = assembly.originalPositions;
	detail::DefectJacobian jacobian(assembly, detail::placeMasses(assembly), 0.1);
	jacobian.linearize(flat);
	Positions bent = flat;
	bent(2, 2) += 0.2; // the middle of the first border
	const Eigen::VectorXd none = jacobian.scaled(flatDefects(assembly, flat), flat);
	EXPECT_LT(none.norm(), 1e-12);
	ASSERT_TRUE(jacobian.foresee(flat, bent));
	EXPECT_FALSE(jacobian.foresee(flat, bent)); // it has been
	// To first order a step along the rows ends where the turn is what is allowed.
	const Eigen::VectorXd residual = jacobian.linearResidual(none);
	const Eigen::VectorXd change = jacobian.apply(bent - flat);
	int row = 0;
	change.minCoeff(&row); // the one that turns most
	const Positions part = flat + (bent - flat) * (-residual[row] / change[row]);
	const double turn = detail::turnAt({1, 2, 3}, part);
	EXPECT_NEAR(turn, 0.1, 0.1 * 0.1);
	jacobian.freeBorders(true);
	jacobian.linearize(flat);
	EXPECT_FALSE(jacobian.foresee(flat, bent));
}

} // namespace
} // namespace developable::test
