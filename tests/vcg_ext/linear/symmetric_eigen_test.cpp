// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/linear.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace developable::test {
namespace {

SmallMatrix randomSymmetric(int size, unsigned seed) {
	std::mt19937 random(seed);
	SmallMatrix matrix(size, size);
	for (int row = 0; row < size; ++row)
		for (int column = 0; column <= row; ++column)
			matrix(row, column) = matrix(column, row) = 2.0 * random() / std::mt19937::max() - 1;
	return matrix;
}

TEST(SymmetricEigen, KnowsThoseOfATurnedEllipse) {
	const double angle = 0.4;
	SmallMatrix turn(2, 2);
	turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
	SmallVector squares(2);
	squares << 4, 9;
	const SymmetricEigen eigen = symmetricEigen(turn * squares.asDiagonal() * turn.transpose());
	EXPECT_NEAR(eigen.values[0], 4, 1e-14);
	EXPECT_NEAR(eigen.values[1], 9, 1e-14);
	EXPECT_NEAR(std::abs(eigen.vectors.col(1).dot(turn.col(1))), 1, 1e-14);
}

TEST(SymmetricEigen, TakesAMatrixApartWhateverItsSize) {
	for (int size = 1; size <= mostSymmetricRows; ++size) {
		const SmallMatrix matrix = randomSymmetric(size, size);
		const SymmetricEigen eigen = symmetricEigen(matrix);
		ASSERT_EQ(eigen.values.size(), size);
		for (int i = 1; i < size; ++i)
			EXPECT_LE(eigen.values[i - 1], eigen.values[i]);
		const SmallMatrix again = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
		EXPECT_LT((again - matrix).norm(), 1e-13);
		EXPECT_LT((eigen.vectors.transpose() * eigen.vectors - SmallMatrix::Identity(size, size)).norm(),
				  1e-13);
	}
}

} // namespace
} // namespace developable::test
