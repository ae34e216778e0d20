// SPDX-License-Identifier: GPL-3.0-or-later
// shape_and_pattern.cpp: the system of a step, and the guarded step.
#include "shape_and_pattern.h"

#include "developable/descent/descent.h"
#include "developable/geometry/geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace developable::detail {

namespace {

constexpr int mostTrials = 12;       // halvings of a step
constexpr int mostSettlings = 3;     // steps of the pattern after each
constexpr double settled = 1e-2;     // decrease of Ψ, as a share, that is worth another
constexpr double rigidMotion = 1e-9; // only rigid motions have no stiffness; this much keeps pieces in place
constexpr double rounding = 1e-13;   // of the stiffest bound: that much of what is soft is lost beside it

double areaOf(const PatchAssembly& assembly) {
	double sum = 0;
	for (const auto& places : assembly.trianglePlaces.colwise())
		sum += triangleFrame(assembly.originalPositions, places).normal.norm() / 2;
	return sum;
}

} // namespace

ShapeAndPatternSteps::ShapeAndPatternSteps(const PatchAssembly& assembly, const Nearness& nearness,
										   const DisplacementBound& bound, BendingBound& bending,
										   const StrainPenalty& penalty, const HeldGrain& grain)
	: assembly_(assembly), nearness_(nearness), bound_(bound), bending_(bending), penalty_(penalty),
	  grain_(grain), order_(assembly), area_(areaOf(assembly)) {}

double ShapeAndPatternSteps::value(const ShapeAndPattern& unknowns) const {
	return distanceCost(unknowns.shape) + bound_.value(penalty_.edge(), unknowns.shape) +
		   bending_.value(unknowns.shape) + penalty_.value(unknowns.shape, unknowns.pattern);
}

double ShapeAndPatternSteps::step(ShapeAndPattern& unknowns) {
	bending_.take(unknowns.shape);
	Eigen::VectorXd gradient;
	const Eigen::VectorXd whole = direction(unknowns, gradient);
	if (!solvable_)
		return 0;
	const auto shapeSize = unknowns.shape.size(), patternSize = unknowns.pattern.size();
	const double slope = gradient.dot(whole), before = value(unknowns);
	double length = std::min(1.0, 4 * lastLength_);
	for (int trial = 0; trial < mostTrials; ++trial, length /= 2) {
		ShapeAndPattern next = {
			unknowns.shape + length * whole.head(shapeSize).reshaped(3, unknowns.shape.cols()),
			unknowns.pattern + length * whole.tail(patternSize).reshaped(2, unknowns.pattern.cols())};
		if (!std::isfinite(penalty_.value(next.shape, next.pattern)))
			next.pattern = unknowns.pattern; // where the step flips triangles the pattern only settles
		grain_.align(next.shape, next.pattern);
		settle(next);
		if (descendsEnough(before, slope, length, value(next)) && order_.holds(next.shape)) {
			unknowns = std::move(next);
			lastLength_ = length;
			return -slope / std::abs(before);
		}
	}
	lastLength_ = 1;
	return 0;
}

Eigen::VectorXd ShapeAndPatternSteps::direction(const ShapeAndPattern& unknowns, Eigen::VectorXd& gradient) {
	const int shapeSize = static_cast<int>(unknowns.shape.size());
	const int size = shapeSize + static_cast<int>(unknowns.pattern.size());
	gradient = Eigen::VectorXd::Zero(size);
	Entries entries;
	entries.reserve(3 * nearness_.metric.nonZeros() + 6 * assembly_.placeCount() +
					120 * penalty_.triangles().count() + size);
	addMetric(unknowns.shape, gradient, entries);
	addBound(unknowns.shape, gradient, entries);
	bending_.addDerivatives(unknowns.shape, gradient, entries);
	for (int t = 0; t < penalty_.triangles().count(); ++t)
		addElement(t, penalty_.element(t, unknowns.shape, unknowns.pattern), gradient, entries);
	addBorder(unknowns.pattern, shapeSize, gradient, entries);
	solvable_ = factorize(whole_, size, entries, shapeSize);
	if (!solvable_)
		return gradient;
	Eigen::MatrixXd slopes = grain_.slopes(unknowns.shape, unknowns.pattern, true);
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (assembly_.placeFixed[place])
			slopes.middleRows<3>(3 * place).setZero();
	return heldDirection([&](const Eigen::VectorXd& v) { return whole_.factorization.solve(v); }, gradient,
						 slopes);
}

void ShapeAndPatternSteps::addMetric(const Positions& shape, Eigen::VectorXd& gradient,
									 Entries& entries) const {
	const Eigen::MatrixXd d = (shape - nearness_.aim).transpose();
	const Positions force = (nearness_.metric.selfadjointView<Eigen::Lower>() * d).transpose() / area_;
	for (int place = 0; place < assembly_.placeCount(); ++place)
		if (!assembly_.placeFixed[place])
			gradient.segment<3>(3 * place) = force.col(place);
	for (int column = 0; column < nearness_.metric.cols(); ++column)
		for (SparseMatrix::InnerIterator entry(nearness_.metric, column); entry; ++entry)
			for (int axis = 0; axis < 3; ++axis)
				entries.emplace_back(3 * static_cast<int>(entry.row()) + axis, 3 * column + axis,
									 entry.value() / area_);
}

void ShapeAndPatternSteps::addBound(const Positions& shape, Eigen::VectorXd& gradient,
									Entries& entries) const {
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		if (assembly_.placeFixed[place])
			continue;
		gradient.segment<3>(3 * place) += bound_.gradient(penalty_.edge(), shape, place);
		const Eigen::Matrix3d block = bound_.hessian(penalty_.edge(), shape, place);
		for (int row = 0; row < 3; ++row)
			for (int column = 0; column <= row; ++column)
				entries.emplace_back(3 * place + row, 3 * place + column, block(row, column));
	}
}

void ShapeAndPatternSteps::addElement(int triangle, const StrainPenalty::Element& element,
									  Eigen::VectorXd& gradient, Entries& entries) const {
	int index[15];
	for (int corner = 0; corner < 3; ++corner) {
		const int place = penalty_.triangles().shaped(corner, triangle);
		const int vertex = penalty_.triangles().flat(corner, triangle);
		for (int axis = 0; axis < 3; ++axis)
			index[3 * corner + axis] = assembly_.placeFixed[place] ? -1 : 3 * place + axis;
		for (int axis = 0; axis < 2; ++axis)
			index[9 + 2 * corner + axis] = 3 * assembly_.placeCount() + 2 * vertex + axis;
	}
	for (int i = 0; i < 15; ++i) {
		if (index[i] < 0)
			continue;
		gradient[index[i]] += element.gradient[i];
		for (int j = 0; j <= i; ++j)
			if (index[j] >= 0)
				entries.emplace_back(std::max(index[i], index[j]), std::min(index[i], index[j]),
									 element.hessian(i, j));
	}
}

/// \param first  row of the pattern's first coordinate
void ShapeAndPatternSteps::addBorder(const Eigen::Matrix2Xd& pattern, int first, Eigen::VectorXd& gradient,
									 Entries& entries) const {
	for (const BorderFans::EdgeElement& element : penalty_.borderElements(pattern)) {
		const auto index = [&](int i) { return first + 2 * element.ends[i / 2] + i % 2; };
		for (int i = 0; i < 4; ++i) {
			gradient[index(i)] += element.gradient[i];
			for (int j = 0; j <= i; ++j)
				entries.emplace_back(std::max(index(i), index(j)), std::min(index(i), index(j)),
									 element.hessian(i, j));
		}
	}
}

bool ShapeAndPatternSteps::factorize(System& system, int size, Entries& entries, int firstOfPattern) const {
	double stiffest = 0;
	for (const auto& entry : entries)
		stiffest = std::max(stiffest, entry.value());
	for (int i = 0; i < size; ++i)
		entries.emplace_back(i, i, i < firstOfPattern ? 0 : rigidMotion / area_);
	if (system.factorization.factorize(system.matrix.of(entries, size)))
		return true;
	for (auto entry = entries.end() - size; entry != entries.end(); ++entry)
		*entry = {entry->row(), entry->col(), entry->value() + rounding * stiffest};
	return system.factorization.factorize(system.matrix.of(entries, size));
}

void ShapeAndPatternSteps::settle(ShapeAndPattern& unknowns) {
	double value = penalty_.value(unknowns.shape, unknowns.pattern);
	for (int i = 0; i < mostSettlings && std::isfinite(value); ++i)
		if (!settleOnce(unknowns, value))
			return;
}

/// \return whether another step may be worth its while
bool ShapeAndPatternSteps::settleOnce(ShapeAndPattern& unknowns, double& value) {
	const int size = static_cast<int>(unknowns.pattern.size());
	Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
	Entries entries;
	entries.reserve(21 * penalty_.triangles().count() + size);
	for (int t = 0; t < penalty_.triangles().count(); ++t) {
		const StrainPenalty::FlatElement element = penalty_.flatElement(t, unknowns.shape, unknowns.pattern);
		const auto index = [&](int i) { return 2 * penalty_.triangles().flat(i / 2, t) + i % 2; };
		for (int i = 0; i < 6; ++i) {
			gradient[index(i)] += element.gradient[i];
			for (int j = 0; j <= i; ++j)
				entries.emplace_back(std::max(index(i), index(j)), std::min(index(i), index(j)),
									 element.hessian(i, j));
		}
	}
	addBorder(unknowns.pattern, 0, gradient, entries);
	if (!factorize(pattern_, size, entries, 0))
		return false;
	const Eigen::VectorXd direction =
		heldDirection([&](const Eigen::VectorXd& v) { return pattern_.factorization.solve(v); }, gradient,
					  grain_.slopes(unknowns.shape, unknowns.pattern, false));
	const double slope = gradient.dot(direction);
	double length = 1;
	for (int trial = 0; trial < mostTrials; ++trial, length /= 2) {
		Eigen::Matrix2Xd next = unknowns.pattern + length * direction.reshaped(2, unknowns.pattern.cols());
		grain_.align(unknowns.shape, next);
		const double nextValue = penalty_.value(unknowns.shape, next);
		if (!descendsEnough(value, slope, length, nextValue))
			continue;
		unknowns.pattern = next;
		value = nextValue;
		return -slope > settled * std::abs(value);
	}
	return false;
}

} // namespace developable::detail
