// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../cmake/cholmod/eigen_routines.h"

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <vector>

namespace {

using Matrix = Eigen::MatrixXd;

/// What each routine makes of the same random numbers.
using Results = std::vector<Matrix>;

/// A matrix whose data begin `shift` numbers into its memory, and whose columns lie `rows` + 3 numbers apart.
class Shifted {
public:
	Shifted(const Matrix& values, int shift)
		: stride(static_cast<int>(values.rows()) + 3), memory_(stride * values.cols() + shift),
		  data(memory_.data() + shift), rows_(values.rows()), columns_(values.cols()) {
		view() = values;
	}

	Eigen::Map<Matrix, 0, Eigen::OuterStride<>> view() {
		return {data, rows_, columns_, Eigen::OuterStride<>(stride)};
	}

	int stride;

private:
	Eigen::VectorXd memory_;

public:
	double* data;

private:
	Eigen::Index rows_, columns_;
};

/// All that CHOLMOD asks for, on matrices of n rows.
Results results(const DenseRoutines<double>& routines, int n, int k, int shift) {
	std::srand(7);
	const auto random = [&](int rows, int columns) { return Shifted(Matrix::Random(rows, columns), shift); };
	Shifted a = random(n, k), b = random(n + 2, k), across = random(k, n + 2), x = random(k, 1),
			y = random(n, 1);
	Shifted product = random(n, n + 2), product2 = random(n, n + 2), product3 = random(k, n + 2);
	routines.multiply("N", "C", n, n + 2, k, -1, a.data, a.stride, b.data, b.stride, 1, product.data,
					  product.stride);
	routines.multiply("N", "N", n, n + 2, k, 1, a.data, a.stride, across.data, across.stride, 0,
					  product2.data, product2.stride);
	routines.multiply("C", "N", k, n + 2, n, -1, a.data, a.stride, product.data, product.stride, 1,
					  product3.data, product3.stride);
	Shifted image = random(n, 1), image2 = random(k, 1);
	routines.multiplyVector("N", n, k, -1, a.data, a.stride, x.data, 1, 1, image.data, 1);
	routines.multiplyVector("C", n, k, -1, a.data, a.stride, y.data, 1, 1, image2.data, 1);
	Shifted update(Matrix::Zero(n, n), shift);
	routines.rankUpdate(n, k, 1, a.data, a.stride, 0, update.data, update.stride);
	const Matrix root = Matrix::Random(n, n);
	Shifted factor(root.lazyProduct(root.transpose()) + n * Matrix::Identity(n, n), shift);
	EXPECT_EQ(routines.factorize(n, factor.data, factor.stride), 0);
	Shifted left = random(n, k), left2 = random(n, k), right = random(k, n), vector = random(n, 1),
			vector2 = random(n, 1);
	routines.solveTriangular("L", "N", n, k, 1, factor.data, factor.stride, left.data, left.stride);
	routines.solveTriangular("L", "C", n, k, 1, factor.data, factor.stride, left2.data, left2.stride);
	routines.solveTriangular("R", "C", k, n, 1, factor.data, factor.stride, right.data, right.stride);
	routines.solveVector("N", n, factor.data, factor.stride, vector.data, 1);
	routines.solveVector("C", n, factor.data, factor.stride, vector2.data, 1);
	return {product.view(),
			product2.view(),
			product3.view(),
			image.view(),
			image2.view(),
			update.view(),
			factor.view().triangularView<Eigen::Lower>(),
			left.view(),
			left2.view(),
			right.view(),
			vector.view(),
			vector2.view()};
}

/// The same by the definitions, with nothing of Eigen's blocked kernels.
Results expected(int n, int k) {
	std::srand(7);
	const auto random = [](int rows, int columns) { return Matrix(Matrix::Random(rows, columns)); };
	const Matrix a = random(n, k), b = random(n + 2, k), across = random(k, n + 2), x = random(k, 1),
				 y = random(n, 1);
	const Matrix product = random(n, n + 2) - a.lazyProduct(b.transpose());
	random(n, n + 2);
	const Matrix product3 = random(k, n + 2) - a.transpose().lazyProduct(product);
	const Matrix image = random(n, 1) - a.lazyProduct(x),
				 image2 = random(k, 1) - a.transpose().lazyProduct(y);
	const Matrix update = Matrix(a.lazyProduct(a.transpose())).triangularView<Eigen::Lower>();
	const Matrix root = random(n, n),
				 positive = root.lazyProduct(root.transpose()) + n * Matrix::Identity(n, n);
	Matrix factor = Matrix::Zero(n, n);
	for (int i = 0; i < n; ++i)
		for (int j = 0; j <= i; ++j) {
			const double left = positive(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j));
			factor(i, j) = i == j ? std::sqrt(left) : left / factor(j, j);
		}
	const Matrix inverse = factor.fullPivLu().inverse(), left = inverse.lazyProduct(random(n, k)),
				 left2 = inverse.transpose().lazyProduct(random(n, k)),
				 right = random(k, n).lazyProduct(inverse.transpose());
	const Matrix vector = inverse.lazyProduct(random(n, 1)),
				 vector2 = inverse.transpose().lazyProduct(random(n, 1));
	return {
		product, a.lazyProduct(across), product3, image, image2, update, factor, left, left2, right, vector,
		vector2};
}

/// The largest, as a share of the largest number of each matrix.
double difference(const Results& a, const Results& b) {
	double largest = 0;
	for (std::size_t i = 0; i < a.size(); ++i)
		largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff() / a[i].cwiseAbs().maxCoeff());
	return largest;
}

constexpr int sizes[][2] = {{1, 1}, {2, 3}, {5, 4}, {13, 7}, {12, 24}, {37, 50}, {130, 65}};

void expectRight(const DenseRoutines<double>& routines) {
	for (const auto [n, k] : sizes) {
		const Results right = expected(n, k);
		for (const int shift : {0, 1, 2, 3})
			EXPECT_LT(difference(right, results(routines, n, k, shift)), 1e-13) << n << " x " << k;
		for (const int shift : {1, 2, 3})
			EXPECT_EQ(difference(results(routines, n, k, 0), results(routines, n, k, shift)), 0)
				<< n << " x " << k << ", " << shift;
	}
	Matrix indefinite = Matrix::Identity(9, 9);
	indefinite(6, 6) = -1;
	EXPECT_EQ(routines.factorize(9, indefinite.data(), 9), 7);
}

TEST(DenseRoutines, AreRightOnEveryProcessor) {
	expectRight(eigenRoutines<double>);
}

#ifdef __x86_64__
TEST(DenseRoutines, AreRightInWideRegistersToo) {
	if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
		GTEST_SKIP() << "this processor has no AVX2 with FMA";
	expectRight(routinesForAvx2);
}
#endif

} // namespace
