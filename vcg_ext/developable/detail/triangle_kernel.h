// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_kernel.h: corner angles and their gradients for all triangles, fast.
#pragma once

#include "../triangle_mesh.h"

#include <cmath>

// One source, compiled twice: the processor's wider registers are used where it has them. Without fused
// multiply-add, so that results are the same to the last bit on every machine.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define DEVELOPABLE_WIDE __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define DEVELOPABLE_WIDE
#endif
#define DEVELOPABLE_INLINE inline __attribute__((always_inline))

namespace developable::detail {

/// Vectors in the form that a compiler turns into wide instructions.
struct Vector {
	double x, y, z;
};

DEVELOPABLE_INLINE double dot(const Vector& a, const Vector& b) {
	return a.x * b.x + a.y * b.y + a.z * b.z;
}
DEVELOPABLE_INLINE Vector minus(const Vector& a, const Vector& b) {
	return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// s a + t b
DEVELOPABLE_INLINE Vector combination(double s, const Vector& a, double t, const Vector& b) {
	return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

/// The cotangents of a triangle's corners, and the inverse of twice its area.
struct TriangleShape {
	double cotangent[3];
	double inverseDoubleArea;
};

/// \param u, v  the edges from corner 0 to corners 1 and 2
DEVELOPABLE_INLINE TriangleShape triangleShape(const Vector& u, const Vector& v) {
	const Vector w = minus(v, u);
	const Vector normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
	const double inverse = 1 / std::sqrt(dot(normal, normal));
	return {{dot(u, v) * inverse, -dot(u, w) * inverse, dot(v, w) * inverse}, inverse};
}

/// The gradients of Σ weight_i θ_i with respect to corners 1 and 2; that of corner 0 makes their sum 0. With
/// r_k as in AngleGradients: r_2 = v/|N| − u cot θ_0 / u², r_1 = u/|N| − v cot θ_0 / v², r_0 = −u/|N| − w cot
/// θ_1 / w².
struct WeightedGradients {
	Vector one, two;
};

DEVELOPABLE_INLINE WeightedGradients weightedGradients(const Vector& u, const Vector& v,
													   const TriangleShape& shape, double weight0,
													   double weight1, double weight2) {
	const Vector w = minus(v, u);
	const double inverse = shape.inverseDoubleArea;
	const double a = weight1 - weight0, b = weight2 - weight0, c = weight2 - weight1;
	// a r_2, b r_1 and c r_0
	const Vector r2 = combination(-a * shape.cotangent[0] / dot(u, u), u, a * inverse, v);
	const Vector r1 = combination(b * inverse, u, -b * shape.cotangent[0] / dot(v, v), v);
	const Vector r0 = combination(-c * inverse, u, -c * shape.cotangent[1] / dot(w, w), w);
	return {minus(r2, r0), combination(1, r1, 1, r0)};
}

/// Edges of some triangles that follow each other, coordinate by coordinate.
struct TriangleBlock {
	static constexpr int size = 32;
	double u[3][size], v[3][size], cotangent[3][size], inverseDoubleArea[size];

	/// \param places  of the first triangle; past the last one its edges are repeated
	DEVELOPABLE_INLINE void load(const double* positions, const int* places, int count) {
		for (int i = 0; i < size; ++i) {
			const int* corner = places + 3 * (i < count ? i : count - 1);
			const double *p = positions + 3 * corner[0], *q = positions + 3 * corner[1],
						 *r = positions + 3 * corner[2];
			for (int axis = 0; axis < 3; ++axis) {
				u[axis][i] = q[axis] - p[axis];
				v[axis][i] = r[axis] - p[axis];
			}
		}
	}
	/// Fills in the shapes, in a loop of its own: mixed with more the compiler keeps it out of wide
	/// registers.
	DEVELOPABLE_INLINE void measure() {
		for (int i = 0; i < size; ++i) {
			const TriangleShape shape = triangleShape(edgeU(i), edgeV(i));
			cotangent[0][i] = shape.cotangent[0];
			cotangent[1][i] = shape.cotangent[1];
			cotangent[2][i] = shape.cotangent[2];
			inverseDoubleArea[i] = shape.inverseDoubleArea;
		}
	}

	DEVELOPABLE_INLINE TriangleShape shape(int i) const {
		return {{cotangent[0][i], cotangent[1][i], cotangent[2][i]}, inverseDoubleArea[i]};
	}
	DEVELOPABLE_INLINE Vector edgeU(int i) const { return {u[0][i], u[1][i], u[2][i]}; }
	DEVELOPABLE_INLINE Vector edgeV(int i) const { return {v[0][i], v[1][i], v[2][i]}; }
};

/// The cotangents of all corners.
/// \param cotangents  out, 3 x triangles
DEVELOPABLE_WIDE inline void allCotangents(const double* positions, const int* places, int triangles,
										   double* cotangents) {
	TriangleBlock block;
	for (int first = 0; first < triangles; first += TriangleBlock::size) {
		const int count = std::min(TriangleBlock::size, triangles - first);
		block.load(positions, places + 3 * first, count);
		block.measure();
		for (int i = 0; i < count; ++i)
			for (int corner = 0; corner < 3; ++corner)
				cotangents[3 * (first + i) + corner] = block.cotangent[corner][i];
	}
}

/// Subtracts the gradient of Σ weight · θ over all corners from a gradient.
/// \param weights   per copy
/// \param gradient  in and out, 3 x places
DEVELOPABLE_WIDE inline void subtractAngleGradients(const double* positions, const int* places,
													const int* copies, int triangles, const double* weights,
													double* gradient) {
	TriangleBlock block;
	double weight[3][TriangleBlock::size], one[3][TriangleBlock::size], two[3][TriangleBlock::size];
	for (int first = 0; first < triangles; first += TriangleBlock::size) {
		const int count = std::min(TriangleBlock::size, triangles - first);
		block.load(positions, places + 3 * first, count);
		block.measure();
		for (int i = 0; i < TriangleBlock::size; ++i)
			for (int corner = 0; corner < 3; ++corner)
				weight[corner][i] = i < count ? weights[copies[3 * (first + i) + corner]] : 0;
		for (int i = 0; i < TriangleBlock::size; ++i) {
			const WeightedGradients result = weightedGradients(block.edgeU(i), block.edgeV(i), block.shape(i),
															   weight[0][i], weight[1][i], weight[2][i]);
			one[0][i] = result.one.x, one[1][i] = result.one.y, one[2][i] = result.one.z;
			two[0][i] = result.two.x, two[1][i] = result.two.y, two[2][i] = result.two.z;
		}
		for (int i = 0; i < count; ++i) {
			const int* corner = places + 3 * (first + i);
			for (int axis = 0; axis < 3; ++axis) {
				gradient[3 * corner[0] + axis] += one[axis][i] + two[axis][i];
				gradient[3 * corner[1] + axis] -= one[axis][i];
				gradient[3 * corner[2] + axis] -= two[axis][i];
			}
		}
	}
}

} // namespace developable::detail
