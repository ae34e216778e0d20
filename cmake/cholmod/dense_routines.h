// SPDX-License-Identifier: GPL-3.0-or-later
// dense_routines.h: the few BLAS and LAPACK routines that CHOLMOD calls, as a table to choose at run time.
#pragma once

/// Arguments are those of BLAS; matrices are columns that lie `lda` (`ldb`, `ldc`) numbers apart. Triangles
/// are lower ones without unit diagonals, for CHOLMOD asks for no others.
template <class Scalar>
struct DenseRoutines {
	/// C = α op(A) op(B) + β C.
	void (*multiply)(const char* transA, const char* transB, int m, int n, int k, Scalar alpha,
					 const Scalar* a, int lda, const Scalar* b, int ldb, Scalar beta, Scalar* c, int ldc);
	/// The lower triangle of C = α A Aᴴ + β C.
	void (*rankUpdate)(int n, int k, double alpha, const Scalar* a, int lda, double beta, Scalar* c, int ldc);
	/// Solves op(A) X = α B or X op(A) = α B in the place of B.
	void (*solveTriangular)(const char* side, const char* trans, int m, int n, Scalar alpha, const Scalar* a,
							int lda, Scalar* b, int ldb);
	/// y = α op(A) x + β y.
	void (*multiplyVector)(const char* trans, int m, int n, Scalar alpha, const Scalar* a, int lda,
						   const Scalar* x, int incx, Scalar beta, Scalar* y, int incy);
	/// Solves op(A) x = b in the place of b.
	void (*solveVector)(const char* trans, int n, const Scalar* a, int lda, Scalar* x, int incx);
	/// Puts A's Cholesky factor in its place. \return 0, or the first leading minor that is not positive
	int (*factorize)(int n, Scalar* a, int lda);
};

#ifdef __x86_64__
/// For processors with AVX2 and FMA, and for no others.
extern const DenseRoutines<double> routinesForAvx2;
#endif
