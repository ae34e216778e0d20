// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../cmake/cholmod/eigen_routines.h"
#include "../../cmake/cholmod/split_routines.h"

#include <gtest/gtest.h>
#include <mutex>
#include <new>
#include <set>
#include <thread>
#include <vector>

namespace {

using Matrix = Eigen::MatrixXd;

/// What each routine that is split makes of the same random numbers, of so many rows.
std::vector<Matrix> results(const DenseRoutines<double>& routines, int n, int k) {
	std::srand(7);
	const Matrix a = Matrix::Random(n, k), b = Matrix::Random(n / 2, k);
	Matrix product = Matrix::Random(n, n / 2), update = Matrix::Random(n, n);
	routines.multiply("N", "C", n, n / 2, k, -1, a.data(), n, b.data(), n / 2, 1, product.data(), n);
	routines.rankUpdate(n, k, 1, a.data(), n, 0, update.data(), n);
	Matrix factor = Matrix(update.selfadjointView<Eigen::Lower>()) + n * Matrix::Identity(n, n);
	EXPECT_EQ(routines.factorize(n, factor.data(), n), 0);
	Matrix right = Matrix::Random(k, n), left = Matrix::Random(n, k);
	routines.solveTriangular("R", "C", k, n, 1, factor.data(), n, right.data(), k);
	routines.solveTriangular("L", "N", n, k, 1, factor.data(), n, left.data(), n);
	return {product, update.triangularView<Eigen::Lower>(), factor.triangularView<Eigen::Lower>(), right,
			left};
}

using Split = SplitRoutines<eigenRoutines<double>>;

TEST(SplitRoutines, DoWhatTheWholeOnesDo) {
	for (const auto& [n, k] : {std::pair(9, 4), {300, 250}, {517, 203}}) {
		const std::vector<Matrix> whole = results(eigenRoutines<double>, n, k),
								  split = results(Split::table, n, k);
		for (std::size_t i = 0; i < whole.size(); ++i)
			EXPECT_LT((whole[i] - split[i]).cwiseAbs().maxCoeff(), 1e-12 * whole[i].cwiseAbs().maxCoeff())
				<< i << " of " << n;
	}
}

TEST(SplitRoutines, HaveTheSameBitsOnAnyNumberOfThreads) {
	const std::vector<Matrix> alone = results(Split::table, 517, 203);
	for (const int count : {1, 2, 3, 7}) {
		const DenseThreads threads(count);
		EXPECT_EQ(results(Split::table, 517, 203), alone) << count;
	}
}

TEST(SplitRoutines, NameTheMinorThatIsNotPositive) {
	Matrix indefinite = Matrix::Identity(500, 500);
	indefinite(431, 431) = -1;
	EXPECT_EQ(Split::factorize(500, indefinite.data(), 500), 432);
}

TEST(DenseThreads, WorkSideBySideAndEachPieceOnce) {
	const DenseThreads threads(2);
	for (int round = 0; round < 50; ++round) {
		std::mutex mutex;
		std::multiset<int> pieces;
		DenseThreads::run(20, [&](int piece) {
			const std::lock_guard lock(mutex);
			pieces.insert(piece);
		});
		ASSERT_EQ(pieces.size(), 20);
		ASSERT_EQ(std::set<int>(pieces.begin(), pieces.end()).size(), 20);
	}
	std::mutex mutex;
	std::set<std::thread::id> workers;
	const auto bothHaveBegun = [&] {
		const std::lock_guard lock(mutex);
		return workers.size() == 2;
	};
	DenseThreads::run(2, [&](int) {
		{
			const std::lock_guard lock(mutex);
			workers.insert(std::this_thread::get_id());
		}
		while (!bothHaveBegun())
			std::this_thread::yield();
	});
	EXPECT_EQ(workers.size(), 2);
}

TEST(DenseThreads, TellTheCallerThatMemoryIsGoneAndGoOn) {
	const DenseThreads threads(2);
	for (int round = 0; round < 5; ++round) {
		EXPECT_THROW(DenseThreads::run(8,
									   [](int piece) {
										   if (piece == 5)
											   throw std::bad_alloc();
									   }),
					 std::bad_alloc);
		int done = 0;
		std::mutex mutex;
		DenseThreads::run(8, [&](int) {
			const std::lock_guard lock(mutex);
			++done;
		});
		EXPECT_EQ(done, 8);
	}
}

TEST(DenseThreads, AreThoseOfTheThreadThatMadeThem) {
	const DenseThreads threads(4);
	std::thread([] {
		DenseThreads::run(
			3, [thread = std::this_thread::get_id()](int) { EXPECT_EQ(std::this_thread::get_id(), thread); });
	}).join();
	{
		const DenseThreads inner(1);
		DenseThreads::run(
			3, [thread = std::this_thread::get_id()](int) { EXPECT_EQ(std::this_thread::get_id(), thread); });
	}
}

} // namespace
