// SPDX-License-Identifier: GPL-3.0-or-later
// eigen_routines.h: the routines of dense_routines.h by Eigen, for whatever processor this is compiled for.
#pragma once

#include "dense_routines.h"

// Else the last bit of a product of small matrices would depend on where they lie in memory.
#define EIGEN_GEMM_TO_COEFFBASED_THRESHOLD 1
#include <Eigen/Cholesky>
#include <Eigen/Core>

// Without a name, since it is compiled once for each kind of processor.
namespace {

using Eigen::Index;

template <class Scalar>
using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Block = Eigen::Map<Dense<Scalar>, 0, Eigen::OuterStride<>>;
template <class Scalar>
using Vector = Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>, 0, Eigen::InnerStride<>>;

/// Fortran's matrices are columns that lie `stride` numbers apart.
template <class Scalar>
Block<Scalar> block(const Scalar* data, Index rows, Index columns, int stride) {
	return Block<Scalar>(const_cast<Scalar*>(data), rows, columns, Eigen::OuterStride<>(stride));
}

bool plain(const char* operation) {
	return *operation == 'N';
}

template <class Target, class Product, class Scalar>
void accumulate(Target&& target, const Product& product, Scalar alpha, Scalar beta) {
	if (beta == Scalar(0))
		target.setZero();
	else if (beta != Scalar(1))
		target *= beta;
	target.noalias() += alpha * product;
}

template <class Scalar>
void multiply(const char* transA, const char* transB, int m, int n, int k, Scalar alpha, const Scalar* a,
			  int lda, const Scalar* b, int ldb, Scalar beta, Scalar* c, int ldc) {
	auto target = block(c, m, n, ldc);
	const auto left = plain(transA) ? block(a, m, k, lda) : block(a, k, m, lda);
	const auto right = plain(transB) ? block(b, k, n, ldb) : block(b, n, k, ldb);
	if (plain(transA) && plain(transB))
		accumulate(target, left * right, alpha, beta);
	else if (plain(transA))
		accumulate(target, left * right.adjoint(), alpha, beta);
	else if (plain(transB))
		accumulate(target, left.adjoint() * right, alpha, beta);
	else
		accumulate(target, left.adjoint() * right.adjoint(), alpha, beta);
}

/// The lower triangle of C = α A Aᴴ + β C.
template <class Scalar>
void rankUpdate(int n, int k, double alpha, const Scalar* a, int lda, double beta, Scalar* c, int ldc) {
	auto target = block(c, n, n, ldc);
	if (beta == 0)
		target.template triangularView<Eigen::Lower>().setZero();
	else if (beta != 1)
		target.template triangularView<Eigen::Lower>() *= Scalar(beta);
	target.template selfadjointView<Eigen::Lower>().rankUpdate(block(a, n, k, lda), Scalar(alpha));
}

/// Of a lower triangle without unit diagonal, from the left or the right.
template <class Scalar, class Target>
void solveTriangular(bool fromLeft, bool plainOperation, const Block<Scalar>& matrix, Target&& target) {
	const auto lower = matrix.template triangularView<Eigen::Lower>();
	const auto upper = matrix.adjoint().template triangularView<Eigen::Upper>();
	if (fromLeft && plainOperation)
		lower.solveInPlace(target);
	else if (fromLeft)
		upper.solveInPlace(target);
	else if (plainOperation)
		lower.template solveInPlace<Eigen::OnTheRight>(target);
	else
		upper.template solveInPlace<Eigen::OnTheRight>(target);
}

template <class Scalar>
void solveTriangular(const char* side, const char* trans, int m, int n, Scalar alpha, const Scalar* a,
					 int lda, Scalar* b, int ldb) {
	const int size = *side == 'L' ? m : n;
	auto target = block(b, m, n, ldb);
	if (alpha != Scalar(1))
		target *= alpha;
	solveTriangular<Scalar>(*side == 'L', plain(trans), block(a, size, size, lda), target);
}

template <class Scalar>
void multiplyVector(const char* trans, int m, int n, Scalar alpha, const Scalar* a, int lda, const Scalar* x,
					int incx, Scalar beta, Scalar* y, int incy) {
	const auto matrix = block(a, m, n, lda);
	const Vector<Scalar> from(const_cast<Scalar*>(x), plain(trans) ? n : m, Eigen::InnerStride<>(incx));
	Vector<Scalar> to(y, plain(trans) ? m : n, Eigen::InnerStride<>(incy));
	if (plain(trans))
		accumulate(to, matrix * from, alpha, beta);
	else
		accumulate(to, matrix.adjoint() * from, alpha, beta);
}

template <class Scalar>
void solveVector(const char* trans, int n, const Scalar* a, int lda, Scalar* x, int incx) {
	Vector<Scalar> target(x, n, Eigen::InnerStride<>(incx));
	solveTriangular<Scalar>(true, plain(trans), block(a, n, n, lda), target);
}

/// \return 0, or which leading minor is not positive definite, counted from 1
template <class Scalar>
int factorize(int n, Scalar* a, int lda) {
	auto target = block(a, n, n, lda);
	return static_cast<int>(Eigen::internal::llt_inplace<Scalar, Eigen::Lower>::blocked(target)) + 1;
}

template <class Scalar>
constexpr DenseRoutines<Scalar> eigenRoutines = {multiply<Scalar>,        rankUpdate<Scalar>,
												 solveTriangular<Scalar>, multiplyVector<Scalar>,
												 solveVector<Scalar>,     factorize<Scalar>};

} // namespace
