// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_metric.h"
#include "support/newton_checks.h"

namespace developable::test {
namespace {

TEST(BendingMetric, OfAnAffineDisplacementOfASheetIsItsMeanSquare) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 12, flatSheet));
	detail::BendingMetric metric(assembly, {}, 0);
	metric.setSmoothness({Eigen::VectorXd::Constant(1, 1)});
	ASSERT_TRUE(metric.factorize());
	Eigen::Matrix3d slope;
	slope << 0.3, -0.2, 1, 0.5, 0.1, 0.4, -0.7, 0.2, 0.6;
	const Positions affine = (slope * assembly.originalPositions).colwise() + Eigen::Vector3d(1, 2, 3);
	double meanSquare = 0;
	for (int place = 0; place < assembly.placeCount(); ++place)
		meanSquare += metric.placeMass()[place] * affine.col(place).squaredNorm();
	EXPECT_NEAR(metric.placeMass().sum(), 1, 1e-13);
	EXPECT_NEAR(metric.squaredNorm(affine), meanSquare, 1e-9 * meanSquare);
	EXPECT_LT((metric.solve(metric.apply(affine)) - affine).norm(), 1e-8 * affine.norm());
}

TEST(BendingMetric, IsTheThinPlateWithoutUnit) {
	// d = x²/2s² along z on a sheet of side s: the bending part is α s⁴ · (∫ (d'')² = 1/s²) / s² = α.
	for (const int cells : {8, 16, 32}) {
		for (const double scale : {1.0, 20.0}) {
			TriangleMesh mesh = grid(cells + 1, cells + 1, flatSheet);
			mesh.positions *= scale;
			const PatchAssembly assembly = assembled(mesh);
			const auto squaredNorm = [&](double smoothness, double rods) {
				Positions displacement = Positions::Zero(3, assembly.placeCount());
				displacement.row(2) =
					assembly.originalPositions.row(0).array().square() / (2 * scale * scale);
				NewtonTuning tuning;
				tuning.borderStiffness = rods;
				detail::BendingMetric metric(assembly, tuning, 0);
				metric.setSmoothness({Eigen::VectorXd::Constant(1, smoothness)});
				return metric.squaredNorm(displacement);
			};
			EXPECT_NEAR((squaredNorm(2e-3, 0) - squaredNorm(1e-3, 0)) / 1e-3, 1, 1e-9) << cells;
			// Two of the four borders bend, but for half an edge at each of their ends: β s^5 · 2 s (1/s²)² /
			// s².
			EXPECT_NEAR((squaredNorm(1e-3, 0.3) - squaredNorm(1e-3, 0)) / 1e-3, 0.6 * (1 - 1.0 / cells),
						1e-9);
		}
	}
}

TEST(BendingMetric, MakesTrianglesMoveAsOnePiece) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, flatSheet));
	detail::BendingMetric metric(assembly, {}, 0);
	metric.setSmoothness({Eigen::VectorXd::Constant(1, 1e-3)});
	const auto places = assembly.trianglePlaces.col(13);
	Positions force = Positions::Zero(3, assembly.placeCount());
	force(2, places[1]) = 1;
	double stretch = 1e300;
	for (int times = 0; times < 12; ++times) {
		ASSERT_TRUE(metric.factorize());
		const Positions displacement = metric.solve(force);
		EXPECT_LT((metric.apply(displacement) - force).norm(), 1e-9);
		const double less =
			std::abs(displacement(2, places[1]) - displacement(2, places[2])) / displacement.norm();
		EXPECT_LT(less, stretch);
		stretch = less;
		metric.stiffen({13});
	}
	EXPECT_LT(stretch, 1e-4);
	const Positions together = Positions::Constant(3, assembly.placeCount(), 0.5);
	EXPECT_NEAR(metric.squaredNorm(together), 0.75, 1e-9); // all at once moves as before
	EXPECT_FALSE(metric.tooStiff());
	std::vector<int> most(21);
	std::iota(most.begin(), most.end(), 0);
	metric.stiffen(most);
	EXPECT_TRUE(metric.tooStiff());
}

TEST(BendingMetric, MakesTrianglesStifferThatAreHeldAtTwoCorners) {
	const TriangleMesh mesh = jitteredGrid(5, 5, flatSheet);
	PatchAssembly assembly = assembled(mesh);
	const Eigen::Vector3i places = assembly.trianglePlaces.col(13);
	assembly.placeFixed[places[0]] = assembly.placeFixed[places[1]] = 1;
	detail::BendingMetric metric(assembly, {}, 0);
	metric.setSmoothness({Eigen::VectorXd::Constant(1, 1e-3)});
	Positions force = Positions::Zero(3, assembly.placeCount());
	force(2, places[2]) = 1;
	ASSERT_TRUE(metric.factorize());
	const double before = metric.solve(force)(2, places[2]);
	for (int times = 0; times < 8; ++times)
		metric.stiffen({13});
	ASSERT_TRUE(metric.factorize());
	const Positions displacement = metric.solve(force);
	EXPECT_LT(displacement(2, places[2]), 1e-3 * before);
	EXPECT_EQ(displacement.col(places[0]), Eigen::Vector3d::Zero());
}

TEST(BendingMetric, LoosensWhatWasMadeStifferAndKeepsPlacesHeavy) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 5, saddle));
	const Eigen::VectorXd masses = Eigen::VectorXd::LinSpaced(assembly.placeCount(), 0, 1);
	detail::BendingMetric loosened(assembly, {}, 0), never(assembly, {}, 0);
	for (detail::BendingMetric* metric : {&loosened, &never})
		metric->setSmoothness({Eigen::VectorXd::Constant(1, 1e-4)});
	EXPECT_FALSE(loosened.loosen());
	for (int times = 0; times < 30; ++times) // far beyond what a sum could be taken back from
		loosened.stiffen({13, 14});
	for (detail::BendingMetric* metric : {&loosened, &never})
		metric->weigh(masses);
	EXPECT_TRUE(loosened.loosen());
	EXPECT_EQ(Eigen::MatrixXd(loosened.matrix()), Eigen::MatrixXd(never.matrix()));
	EXPECT_EQ(loosened.weight(), never.weight());
	EXPECT_FALSE(loosened.loosen());
}

TEST(BendingMetric, DoesWithLittleMemory) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	detail::BendingMetric little(assembly, {}, 1), much(assembly, {}, 0);
	const Positions force = Positions::Random(3, assembly.placeCount());
	for (detail::BendingMetric* metric : {&little, &much}) {
		metric->setSmoothness({Eigen::VectorXd::Constant(1, 1e-4)});
		ASSERT_TRUE(metric->factorize());
	}
	const Positions exact = much.solve(force);
	EXPECT_LT((little.solve(force) - exact).norm(), 1e-6 * exact.norm());
	EXPECT_NE(little.solve(force), exact); // so it did take another way
}

} // namespace
} // namespace developable::test
