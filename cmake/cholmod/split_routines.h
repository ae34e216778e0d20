// SPDX-License-Identifier: GPL-3.0-or-later
// split_routines.h: the routines of dense_routines.h with large ones cut into pieces for several threads.
#pragma once

#include "dense_routines.h"
#include "dense_threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// Pieces depend on nothing but the sizes of the matrices, so that the bits do not depend on the threads.
///
/// \tparam whole  what works on one piece
template <const DenseRoutines<double>& whole>
class SplitRoutines {
public:
	static void multiply(const char* transA, const char* transB, int m, int n, int k, double alpha,
						 const double* a, int lda, const double* b, int ldb, double beta, double* c,
						 int ldc) {
		const bool byRows = *transA == 'N';
		forEachPiece(evenly(byRows ? m : 1, double(m) * n * k), [&](int first, int rows) {
			whole.multiply(transA, transB, byRows ? rows : m, n, k, alpha, a + first, lda, b, ldb, beta,
						   c + first, ldc);
		});
	}

	static void rankUpdate(int n, int k, double alpha, const double* a, int lda, double beta, double* c,
						   int ldc) {
		Pieces pieces = evenly(n, 0.5 * n * n * k);
		for (int piece = 1; piece < pieces.count; ++piece) // rows become longer
			pieces.start[piece] = static_cast<int>(n * std::sqrt(double(piece) / pieces.count));
		forEachPiece(pieces, [&](int first, int rows) {
			if (first > 0)
				whole.multiply("N", "C", rows, first, k, alpha, a + first, lda, a, lda, beta, c + first, ldc);
			whole.rankUpdate(rows, k, alpha, a + first, lda, beta, c + first + std::ptrdiff_t(first) * ldc,
							 ldc);
		});
	}

	static void solveTriangular(const char* side, const char* trans, int m, int n, double alpha,
								const double* a, int lda, double* b, int ldb) {
		const bool byRows = *side == 'R';
		forEachPiece(evenly(byRows ? m : 1, 0.5 * m * n * (byRows ? n : m)), [&](int first, int rows) {
			whole.solveTriangular(side, trans, byRows ? rows : m, n, alpha, a, lda, b + first, ldb);
		});
	}

	static void multiplyVector(const char* trans, int m, int n, double alpha, const double* a, int lda,
							   const double* x, int incx, double beta, double* y, int incy) {
		whole.multiplyVector(trans, m, n, alpha, a, lda, x, incx, beta, y, incy);
	}

	static void solveVector(const char* trans, int n, const double* a, int lda, double* x, int incx) {
		whole.solveVector(trans, n, a, lda, x, incx);
	}

	static int factorize(int n, double* a, int lda) {
		constexpr int width = 192;
		if (double(n) * n * n / 3 < leastWork)
			return whole.factorize(n, a, lda);
		for (int first = 0; first < n; first += width) {
			const int columns = std::min(width, n - first), below = n - first - columns;
			double* const corner = a + first + std::ptrdiff_t(first) * lda;
			const int failed = whole.factorize(columns, corner, lda);
			if (failed != 0)
				return first + failed;
			if (below == 0)
				break;
			solveTriangular("R", "C", below, columns, 1, corner, lda, corner + columns, lda);
			rankUpdate(below, columns, -1, corner + columns, lda, 1,
					   corner + columns + std::ptrdiff_t(columns) * lda, lda);
		}
		return 0;
	}

	static constexpr DenseRoutines<double> table = {multiply,       rankUpdate,  solveTriangular,
													multiplyVector, solveVector, factorize};

private:
	static constexpr double leastWork = 2e7; ///< multiplications; a thread wakes up in the time of some 10⁵
	static constexpr double pieceWork = 5e6;
	static constexpr int mostPieces = 16;

	/// Rows, without memory of their own: most calls are of small matrices, and many.
	struct Pieces {
		int count;
		std::array<int, mostPieces + 1> start; ///< where each begins, and the end
	};

	static Pieces evenly(int rows, double work) {
		const int count =
			work < leastWork ? 1 : std::min({mostPieces, rows, static_cast<int>(work / pieceWork)});
		Pieces pieces = {count, {}};
		for (int piece = 0; piece <= count; ++piece)
			pieces.start[piece] = static_cast<int>(static_cast<long long>(rows) * piece / count);
		return pieces;
	}

	template <class Work>
	static void forEachPiece(const Pieces& pieces, const Work& work) {
		const auto ofPiece = [&](int piece) {
			work(pieces.start[piece], pieces.start[piece + 1] - pieces.start[piece]);
		};
		if (pieces.count == 1)
			ofPiece(0);
		else
			DenseThreads::run(pieces.count, ofPiece);
	}
};
