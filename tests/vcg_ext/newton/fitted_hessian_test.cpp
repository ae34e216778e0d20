// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_metric.h"
#include "developable/newton/fitted_hessian.h"
#include "developable/newton/unfolded_hinges.h"
#include "support/newton_checks.h"

#include <Eigen/Eigenvalues>
#include <random>

namespace developable::test {
namespace {

/// ∫|f''|² over all triangles.
double bendingOf(const PatchAssembly& assembly, const Eigen::VectorXd& values) {
	const Eigen::VectorXd areas = detail::triangleAreas(assembly, assembly.originalPositions);
	const detail::FittedHessian hessian(assembly, areas);
	double energy = 0;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const detail::TriangleBending bending = hessian.bending(t);
		if (!bending.places.empty())
			energy += (bending.rows * values(bending.places)).squaredNorm();
	}
	return energy;
}

/// The hinge energy Σ (K_e f)² / (A_1 + A_2).
double hingeEnergyOf(const PatchAssembly& assembly, const Eigen::VectorXd& values) {
	const Eigen::VectorXd areas = detail::triangleAreas(assembly, assembly.originalPositions);
	double energy = 0;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		detail::UnfoldedHinges unfolded(assembly, areas, t);
		unfolded.widen();
		for (const detail::UnfoldedHinge& hinge : unfolded.hinges()) {
			double jump = 0;
			for (int i = 0; i < 4; ++i)
				jump += hinge.jump[i] * values[unfolded.places()[hinge.points[i]]];
			energy += jump * jump / hinge.area / 2; // each hinge is met from both sides
		}
	}
	return energy;
}

TriangleMesh alternating(int columns) {
	TriangleMesh mesh = grid(columns, columns, flatSheet);
	for (int cell = 0; cell < (columns - 1) * (columns - 1); ++cell)
		if ((cell % (columns - 1) + cell / (columns - 1)) % 2 == 1) {
			const int a = cell / (columns - 1) * columns + cell % (columns - 1);
			mesh.triangles.col(2 * cell) << a, a + 1, a + columns;
			mesh.triangles.col(2 * cell + 1) << a + 1, a + columns + 1, a + columns;
		}
	return mesh;
}

/// Rows of points each shifted by its own share of a cell, squeezed until angles are of about a degree.
TriangleMesh thin() {
	TriangleMesh mesh = jitteredGrid(9, 9, flatSheet, 0.3);
	mesh.positions.row(1) *= 0.03;
	return mesh;
}

std::vector<TriangleMesh> flatMeshes() {
	return {grid(9, 9, flatSheet), alternating(9), jitteredGrid(9, 9, flatSheet, 0.3), thin()};
}

TEST(FittedHessian, PassesThePatchTestOnEveryTriangulation) {
	for (const TriangleMesh& mesh : flatMeshes()) {
		const PatchAssembly assembly = assembled(mesh);
		const Eigen::ArrayXd x = assembly.originalPositions.row(0), y = assembly.originalPositions.row(1);
		const double area = detail::triangleAreas(assembly, assembly.originalPositions).sum();
		for (const Eigen::Vector3d& h : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1),
										 Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0.5, -1.3, 2)}) {
			const Eigen::VectorXd values =
				h[0] * x * x / 2 + h[1] * x * y + h[2] * y * y / 2 + 3 * x - 2 * y + 7;
			const double exact = area * (h[0] * h[0] + 2 * h[1] * h[1] + h[2] * h[2]);
			EXPECT_NEAR(bendingOf(assembly, values), exact, 1e-9 * exact)
				<< smallestAngle(assembly, assembly.originalPositions);
		}
	}
}

TEST(FittedHessian, LeavesNoZigzagFree) {
	std::mt19937 random(5);
	for (const TriangleMesh& mesh :
		 {grid(9, 9, flatSheet), alternating(9), jitteredGrid(9, 9, flatSheet, 0.3),
		  jitteredGrid(9, 9, quarterCylinder, 0.3)}) {
		const PatchAssembly assembly = assembled(mesh);
		for (int i = 0; i < 20; ++i) {
			Eigen::VectorXd values(assembly.placeCount());
			for (double& value : values)
				value = 2.0 * random() / std::mt19937::max() - 1;
			EXPECT_GT(bendingOf(assembly, values), 0.1 * hingeEnergyOf(assembly, values));
		}
		for (int place = 0; place < assembly.placeCount(); ++place) {
			const Eigen::VectorXd values = Eigen::VectorXd::Unit(assembly.placeCount(), place);
			EXPECT_GT(bendingOf(assembly, values), 0.1 * hingeEnergyOf(assembly, values));
		}
	}
}

TEST(FittedHessian, ConvergesOnASheetAndOnACylinder) {
	double last[2] = {1e300, 1e300};
	for (const int columns : {11, 21, 41}) {
		const PatchAssembly sheet = assembled(jitteredGrid(columns, columns, flatSheet, 0.3));
		const Eigen::ArrayXd x = sheet.originalPositions.row(0), y = sheet.originalPositions.row(1);
		// f = sin 3x cos 2y on the sheet's box, by the midpoint rule.
		const double width = x.maxCoeff() - x.minCoeff(), height = y.maxCoeff() - y.minCoeff();
		double exact = 0;
		const int n = 400;
		for (int i = 0; i < n; ++i)
			for (int j = 0; j < n; ++j) {
				const double u = x.minCoeff() + (i + 0.5) * width / n,
							 v = y.minCoeff() + (j + 0.5) * height / n;
				const double f = std::sin(3 * u) * std::cos(2 * v),
							 mixed = 6 * std::cos(3 * u) * std::sin(2 * v);
				exact += (81 * f * f + 16 * f * f + 2 * mixed * mixed) * width * height / (n * n);
			}
		const double error = std::abs(bendingOf(sheet, (3 * x).sin() * (2 * y).cos()) / exact - 1);
		EXPECT_LT(error, 0.6 * last[0]);
		last[0] = error;

		// A coordinate of a cylinder of radius r: |x''| = |n| / r², so the three of them have area / r² in
		// all.
		const PatchAssembly cylinder = assembled(jitteredGrid(columns, columns, quarterCylinder, 0.3));
		const Positions& p = cylinder.originalPositions;
		double bending = 0;
		for (int axis = 0; axis < 3; ++axis)
			bending += bendingOf(cylinder, p.row(axis).transpose());
		const double area = detail::triangleAreas(cylinder, p).sum();
		const double radius = std::hypot(p(0, 0), p(1, 0));
		const double errorThere = std::abs(bending * radius * radius / area - 1);
		EXPECT_LT(errorThere, 0.6 * last[1]);
		last[1] = errorThere;
	}
	EXPECT_LT(last[0], 0.01);
	EXPECT_LT(last[1], 0.01);
}

TEST(FittedHessian, HoldsAllButAffineFunctionsOfAStrip) {
	const PatchAssembly assembly =
		assembled(grid(9, 2, flatSheet)); // two rows of points: no quadratic is told
	const Eigen::VectorXd areas = detail::triangleAreas(assembly, assembly.originalPositions);
	EXPECT_FALSE(detail::FittedHessian(assembly, areas).bending(6).determined);
	Eigen::MatrixXd form = Eigen::MatrixXd::Zero(assembly.placeCount(), assembly.placeCount());
	for (int i = 0; i < assembly.placeCount(); ++i)
		for (int j = 0; j < assembly.placeCount(); ++j) {
			const auto unit = [&](int k) { return Eigen::VectorXd::Unit(assembly.placeCount(), k); };
			form(i, j) = (bendingOf(assembly, unit(i) + unit(j)) - bendingOf(assembly, unit(i)) -
						  bendingOf(assembly, unit(j))) /
						 2;
		}
	const Eigen::VectorXd values = form.selfadjointView<Eigen::Lower>().eigenvalues();
	EXPECT_LT(std::abs(values[2]), 1e-10 * values.maxCoeff());
	EXPECT_GT(values[3], 1e-6 * values.maxCoeff());
}

} // namespace
} // namespace developable::test
