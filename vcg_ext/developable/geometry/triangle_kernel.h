// SPDX-License-Identifier: GPL-3.0-or-later
// triangle_kernel.h: corner angles and their gradients for all triangles, fast.
#pragma once

#include "wide.h"

#include <cstddef>
#include <cstring>

namespace developable::detail {

/// A vector of each of one or several triangles.
template <class Number>
struct Vector {
	Number x, y, z;
};

template <class Number>
DEVELOPABLE_INLINE Number dot(const Vector<Number>& a, const Vector<Number>& b) {
	return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
DEVELOPABLE_INLINE Vector<Number> minus(const Vector<Number>& a, const Vector<Number>& b) {
	return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
DEVELOPABLE_INLINE Vector<Number> times(const Number& s, const Vector<Number>& a) {
	return {s * a.x, s * a.y, s * a.z};
}
template <class Number>
DEVELOPABLE_INLINE Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
	return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Number>
DEVELOPABLE_INLINE Number length(const Vector<Number>& a) {
	return squareRoot(dot(a, a));
}

/// Triangles by their edges from corner 0 to corner 1, from 0 to 2, and from 1 to 2.
template <class Number>
struct TriangleEdges {
	Vector<Number> u, v, w;

	DEVELOPABLE_INLINE TriangleEdges(const Vector<Number>& u_, const Vector<Number>& v_)
		: u(u_), v(v_), w(minus(v_, u_)) {}

	/// Twice the area long.
	DEVELOPABLE_INLINE Vector<Number> normal() const { return cross(u, v); }
};

template <class Number>
struct Cotangents {
	Number corner[3];

	DEVELOPABLE_INLINE explicit Cotangents(const TriangleEdges<Number>& edges) {
		const Number inverse = 1 / length(edges.normal());
		corner[0] = dot(edges.u, edges.v) * inverse;
		corner[1] = -dot(edges.u, edges.w) * inverse;
		corner[2] = dot(edges.v, edges.w) * inverse;
	}
};

/// The gradients of Σ weight_i θ_i with respect to corners 1 and 2; that of corner 0 makes their sum 0.
template <class Number>
struct WeightedGradients {
	Vector<Number> one, two;

	WeightedGradients() = default;
	/// The vectors r_k of AngleGradients are N × u / (|N| u²) for u, −N × v / (|N| v²) and N × w / (|N| w²).
	/// \param a, b  what weights 1 and 2 have more than weight 0
	DEVELOPABLE_INLINE WeightedGradients(const TriangleEdges<Number>& edges, const Number& a,
										 const Number& b) {
		const Vector<Number>&u = edges.u, &v = edges.v, &w = edges.w, normal = edges.normal();
		const Number uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), uuvv = uu * vv;
		const Number inverse = 1 / (length(normal) * (uuvv * ww)); // one division for three
		const Vector<Number> alongW = times((b - a) * inverse * uuvv, w);
		one = cross(normal, minus(times(a * inverse * (vv * ww), u), alongW));
		two = cross(normal, minus(alongW, times(b * inverse * (uu * ww), v)));
	}
};

/// Where a place's coordinates begin.
DEVELOPABLE_INLINE std::ptrdiff_t offset(int place) {
	return 3 * static_cast<std::ptrdiff_t>(place);
}

/// A point as it lies in memory: two coordinates are read and written at once, always the same two, for a
/// processor waits long for a number that it has just stored as a part of others.
struct Point {
	TwoNumbers xy;
	double z;

	DEVELOPABLE_INLINE static Point read(const double* coordinates) {
		Point point;
		std::memcpy(&point.xy, coordinates, sizeof point.xy);
		point.z = coordinates[2];
		return point;
	}
	DEVELOPABLE_INLINE void addTo(double* coordinates) const {
		const TwoNumbers sum = read(coordinates).xy + xy;
		std::memcpy(coordinates, &sum, sizeof sum);
		coordinates[2] += z;
	}
};

/// A point of each triangle as one vector.
template <class Number>
DEVELOPABLE_INLINE Vector<Number> vectorOf(const Point* points) {
	return {gather<Number>([&](int lane) { return points[lane].xy[0]; }),
			gather<Number>([&](int lane) { return points[lane].xy[1]; }),
			gather<Number>([&](int lane) { return points[lane].z; })};
}

/// The edges of as many triangles that follow each other as a Number holds.
/// \param places  of the first one's corners
template <class Number>
DEVELOPABLE_INLINE TriangleEdges<Number> readEdges(const double* positions, const int* places) {
	Point u[width<Number>], v[width<Number>];
	for (int lane = 0; lane < width<Number>; ++lane, places += 3) {
		const Point start = Point::read(positions + offset(places[0])),
					end1 = Point::read(positions + offset(places[1])),
					end2 = Point::read(positions + offset(places[2]));
		u[lane] = {end1.xy - start.xy, end1.z - start.z};
		v[lane] = {end2.xy - start.xy, end2.z - start.z};
	}
	return {vectorOf<Number>(u), vectorOf<Number>(v)};
}

/// Calls kernel.someTriangles<Number>(first) for as many triangles as a Number holds, and for the rest one by
/// one.
template <class Number, class Kernel>
DEVELOPABLE_INLINE void inGroups(const Kernel& kernel, int triangles) {
	int first = 0;
	for (; first + width<Number> <= triangles; first += width<Number>)
		kernel.template someTriangles<Number>(first);
	for (; first < triangles; ++first)
		kernel.template someTriangles<double>(first);
}

/// The cotangents of all corners.
struct CotangentKernel {
	const double* positions;
	const int* places; ///< 3 x triangles
	int triangles;
	double* cotangents; ///< out, 3 x triangles

	template <class Number>
	DEVELOPABLE_INLINE void run() const {
		inGroups<Number>(*this, triangles);
	}

	template <class Number>
	DEVELOPABLE_INLINE void someTriangles(int first) const {
		const Cotangents<Number> result(readEdges<Number>(positions, places + 3 * first));
		for (int lane = 0; lane < width<Number>; ++lane)
			for (int corner = 0; corner < 3; ++corner)
				cotangents[3 * (first + lane) + corner] = at(result.corner[corner], lane);
	}
};

/// The normals of all triangles, one long; 0 of one without area.
struct NormalKernel {
	const double* positions;
	const int* places; ///< 3 x triangles
	int triangles;
	double* normals; ///< out, 3 x triangles

	template <class Number>
	DEVELOPABLE_INLINE void run() const {
		inGroups<Number>(*this, triangles);
	}

	template <class Number>
	DEVELOPABLE_INLINE void someTriangles(int first) const {
		const Vector<Number> normal = readEdges<Number>(positions, places + 3 * first).normal();
		const Number norm = length(normal), divisor = norm > 0 ? norm : every<Number>(1);
		const Number unit[] = {normal.x / divisor, normal.y / divisor, normal.z / divisor};
		for (int lane = 0; lane < width<Number>; ++lane)
			for (int coordinate = 0; coordinate < 3; ++coordinate)
				normals[3 * (first + lane) + coordinate] = at(unit[coordinate], lane);
	}
};

/// Subtracts the gradient of Σ weight · θ over all corners from a gradient.
struct AngleGradientKernel {
	const double* positions;
	const int *places, *copies; ///< 3 x triangles each
	int triangles;
	const double* weights; ///< per copy
	double* gradient;      ///< in and out, 3 x places

	template <class Number>
	DEVELOPABLE_INLINE void run() const {
		inBlocks<Number>(*this, triangles);
	}

	/// First the gradients of all groups, then their sums.
	template <class Number, int groups>
	DEVELOPABLE_INLINE void some(int first) const {
		WeightedGradients<Number> gradients[groups];
		for (int group = 0; group < groups; ++group) {
			const int corner = 3 * (first + group * width<Number>);
			const Number weight0 = weight<Number>(copies + corner);
			gradients[group] = WeightedGradients<Number>(readEdges<Number>(positions, places + corner),
														 weight<Number>(copies + corner + 1) - weight0,
														 weight<Number>(copies + corner + 2) - weight0);
		}
		for (int group = 0; group < groups; ++group)
			subtract(gradients[group], places + 3 * (first + group * width<Number>));
	}

private:
	/// \param copy  of one of the first triangle's corners
	template <class Number>
	DEVELOPABLE_INLINE Number weight(const int* copy) const {
		return gather<Number>([&](int lane) { return weights[copy[3 * lane]]; });
	}

	template <class Number>
	DEVELOPABLE_INLINE void subtract(const WeightedGradients<Number>& gradients, const int* corner) const {
		TwoNumbers ones[width<Number>], twos[width<Number>];
		pairs(gradients.one.x, gradients.one.y, ones);
		pairs(gradients.two.x, gradients.two.y, twos);
		for (int lane = 0; lane < width<Number>; ++lane, corner += 3) {
			const Point one = {ones[lane], at(gradients.one.z, lane)},
						two = {twos[lane], at(gradients.two.z, lane)};
			Point{one.xy + two.xy, one.z + two.z}.addTo(gradient + offset(corner[0]));
			Point{-one.xy, -one.z}.addTo(gradient + offset(corner[1]));
			Point{-two.xy, -two.z}.addTo(gradient + offset(corner[2]));
		}
	}
};

} // namespace developable::detail
