// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/linear.h"

#include <gtest/gtest.h>
#include <random>

namespace developable::test {
namespace {

RepeatedSum::Entries randomEntries(int count, int size, unsigned placesFrom, unsigned valuesFrom) {
	std::mt19937 places(placesFrom), values(valuesFrom);
	RepeatedSum::Entries entries;
	for (int i = 0; i < count; ++i) {
		const int row = static_cast<int>(places() % size), column = static_cast<int>(places() % size);
		entries.emplace_back(row, column, 2.0 * values() / std::mt19937::max() - 1);
	}
	return entries;
}

SparseMatrix expected(const RepeatedSum::Entries& entries, int size) {
	SparseMatrix matrix(size, size);
	matrix.setFromTriplets(entries.begin(), entries.end());
	return matrix;
}

bool sameBits(const SparseMatrix& a, const SparseMatrix& b) {
	return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() && (a - b).norm() == 0;
}

TEST(RepeatedSum, IsEigensSumToTheBitForEntriesAtTheSamePlaces) {
	RepeatedSum sum;
	for (const unsigned values : {1, 2, 3}) { // 300 entries at 100 places: many of them meet
		const auto entries = randomEntries(300, 10, 7, values);
		EXPECT_TRUE(sameBits(sum.of(entries, 10), expected(entries, 10))) << values;
	}
}

TEST(RepeatedSum, FindsPlacesAnewWhereTheyAreOthers) {
	RepeatedSum sum;
	sum.of(randomEntries(300, 40, 7, 1), 40);
	const auto elsewhere = randomEntries(300, 40, 8, 1), more = randomEntries(310, 40, 8, 1),
			   larger = randomEntries(310, 41, 8, 1);
	EXPECT_TRUE(sameBits(sum.of(elsewhere, 40), expected(elsewhere, 40)));
	EXPECT_TRUE(sameBits(sum.of(more, 40), expected(more, 40)));
	EXPECT_TRUE(sameBits(sum.of(larger, 41), expected(larger, 41)));
	EXPECT_TRUE(sameBits(sum.of({}, 3), SparseMatrix(3, 3)));
}

} // namespace
} // namespace developable::test
