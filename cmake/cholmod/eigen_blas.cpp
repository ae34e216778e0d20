// SPDX-License-Identifier: GPL-3.0-or-later
// eigen_blas.cpp: the dense routines under their Fortran names, with the widest registers that there are.
#include "eigen_routines.h"
#include "out_of_memory.h"
#include "split_routines.h"

#include <complex>
#include <new>

namespace {

template <class Scalar>
const DenseRoutines<Scalar>& routines() {
	return eigenRoutines<Scalar>;
}

template <>
const DenseRoutines<double>& routines<double>() {
#ifdef __x86_64__
	static const bool wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
	if (wide)
		return SplitRoutines<routinesForAvx2>::table;
#endif
	return SplitRoutines<eigenRoutines<double>>::table;
}

/// CHOLMOD is C: no exception may pass through it.
template <class Routine>
void withinMemory(const Routine& routine) {
	try {
		routine();
	} catch (const std::bad_alloc&) {
		noteOutOfMemory();
	}
}

} // namespace

#define DEFINE_ROUTINES(Scalar, p, rankName)                                                                 \
	void p##gemm_(const char* transA, const char* transB, const int* m, const int* n, const int* k,          \
				  const Scalar* alpha, const Scalar* a, const int* lda, const Scalar* b, const int* ldb,     \
				  const Scalar* beta, Scalar* c, const int* ldc) {                                           \
		withinMemory([&] {                                                                                   \
			routines<Scalar>().multiply(transA, transB, *m, *n, *k, *alpha, a, *lda, b, *ldb, *beta, c,      \
										*ldc);                                                               \
		});                                                                                                  \
	}                                                                                                        \
	void rankName(const char*, const char*, const int* n, const int* k, const double* alpha,                 \
				  const Scalar* a, const int* lda, const double* beta, Scalar* c, const int* ldc) {          \
		withinMemory([&] { routines<Scalar>().rankUpdate(*n, *k, *alpha, a, *lda, *beta, c, *ldc); });       \
	}                                                                                                        \
	void p##trsm_(const char* side, const char*, const char* trans, const char*, const int* m, const int* n, \
				  const Scalar* alpha, const Scalar* a, const int* lda, Scalar* b, const int* ldb) {         \
		withinMemory(                                                                                        \
			[&] { routines<Scalar>().solveTriangular(side, trans, *m, *n, *alpha, a, *lda, b, *ldb); });     \
	}                                                                                                        \
	void p##gemv_(const char* trans, const int* m, const int* n, const Scalar* alpha, const Scalar* a,       \
				  const int* lda, const Scalar* x, const int* incx, const Scalar* beta, Scalar* y,           \
				  const int* incy) {                                                                         \
		withinMemory([&] {                                                                                   \
			routines<Scalar>().multiplyVector(trans, *m, *n, *alpha, a, *lda, x, *incx, *beta, y, *incy);    \
		});                                                                                                  \
	}                                                                                                        \
	void p##trsv_(const char*, const char* trans, const char*, const int* n, const Scalar* a,                \
				  const int* lda, Scalar* x, const int* incx) {                                              \
		withinMemory([&] { routines<Scalar>().solveVector(trans, *n, a, *lda, x, *incx); });                 \
	}                                                                                                        \
	void p##potrf_(const char*, const int* n, Scalar* a, const int* lda, int* info) {                        \
		*info = 1;                                                                                           \
		withinMemory([&] { *info = routines<Scalar>().factorize(*n, a, *lda); });                            \
	}

extern "C" {
DEFINE_ROUTINES(double, d, dsyrk_)
DEFINE_ROUTINES(std::complex<double>, z, zherk_)
}
