// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/bending_matrix.h"

#include "support/newton_checks.h"

namespace developable::test {
namespace {

/// Of two panels of different area.
PatchAssembly unequalPatches() {
	const TriangleMesh left = jitteredGrid(8, 8, saddle);
	TriangleMesh right = left;
	right.positions.row(0) = 3 - 2 * right.positions.row(0).array();
	return assembled(together(left, right));
}

double relative(const SparseMatrix& a, const SparseMatrix& b) {
	return SparseMatrix(a - b).norm() / b.norm();
}

TEST(BendingMatrix, IsTheSameFromWhatWasFoundBefore) {
	const PatchAssembly assembly = unequalPatches();
	const Eigen::VectorXd masses = detail::placeMasses(assembly);
	const detail::Smoothness first = {Eigen::VectorXd::Constant(2, 1e-3)},
							 smoother = {Eigen::VectorXd::Constant(2, 7e-2)},
							 unequal = {Eigen::Vector2d(1e-3, 7e-2)},
							 withPart = {Eigen::VectorXd::Constant(2, 1e-3), 3e-2};
	detail::BendingMatrix bending(assembly);
	bending.lower(masses, first, 0.3);
	for (const detail::Smoothness& smoothness : {smoother, unequal, withPart, first})
		for (const double rods : {0.0, 0.3}) {
			const SparseMatrix expected = detail::BendingMatrix(assembly).lower(masses, smoothness, rods);
			EXPECT_LT(relative(bending.lower(masses, smoothness, rods), expected), 1e-14);
			detail::BendingMatrix another(assembly);
			another.takeOver(bending);
			EXPECT_LT(relative(another.lower(masses, smoothness, rods), expected), 1e-14);
		}
}

TEST(BendingMatrix, WeighsPatchesByThemselves) {
	const PatchAssembly assembly = unequalPatches();
	const Eigen::VectorXd none = Eigen::VectorXd::Zero(assembly.placeCount());
	const auto of = [&](double left, double right, double part) {
		return detail::BendingMatrix(assembly).lower(none, {Eigen::Vector2d(left, right), part}, 0);
	};
	// Linear in each of the three; the left patch bends by itself.
	EXPECT_LT(relative(of(2, 3, 5), 2 * of(1, 0, 0) + 3 * of(0, 1, 0) + 5 * of(0, 0, 1)), 1e-13);
	EXPECT_GT(relative(of(1, 2, 0), of(2, 1, 0)), 0.1);
	EXPECT_GT(relative(of(0, 0, 1), of(1, 1, 0)), 0.1);
}

TEST(BendingMatrix, ForcesOfHeldPlacesCountButForThemselves) {
	const PatchAssembly free = unequalPatches();
	PatchAssembly held = free;
	for (int place = 0; place < held.placeCount(); place += 3)
		held.placeFixed[place] = 1;
	const detail::Smoothness smoothness = {Eigen::VectorXd::Constant(2, 1e-3)};
	const SparseMatrix bending =
		detail::BendingMatrix(free).lower(Eigen::VectorXd::Zero(free.placeCount()), smoothness, 0.3);
	Positions expected =
		(bending.selfadjointView<Eigen::Lower>() * free.originalPositions.transpose()).transpose();
	EXPECT_EQ(detail::BendingMatrix(free).force(free.originalPositions, smoothness, 0.3), expected);
	for (int place = 0; place < held.placeCount(); place += 3)
		expected.col(place).setZero();
	EXPECT_EQ(detail::BendingMatrix(held).force(free.originalPositions, smoothness, 0.3), expected);
}

} // namespace
} // namespace developable::test
