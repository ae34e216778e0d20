// SPDX-License-Identifier: GPL-3.0-or-later
// slow_local_method.h: the local method of Section 5 written down as plainly as can be, to compare with.
#pragma once

#include "developable/geometry/geometry.h"
#include "developable/local/local_method.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace developable::test {

/// The copy itself, then its neighbours in the order of its corners.
inline std::vector<int> starOf(const PatchAssembly& assembly, int copy) {
	std::vector<int> star = {copy};
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (int corner = 0; corner < 3; ++corner)
			if (assembly.triangleCopies(corner, t) == copy)
				for (const int number : {nextCorner(corner), previousCorner(corner)}) {
					const int other = assembly.triangleCopies(number, t);
					if (std::find(star.begin(), star.end(), other) == star.end())
						star.push_back(other);
				}
	return star;
}

/// T' by the closed form of the corner angles' gradients.
inline double slowDerivative(const PatchAssembly& assembly, const Positions& positions,
							 const Eigen::VectorXd& g, const Eigen::Vector3d& normal, int copy) {
	double derivative = 0;
	for (int t = 0; t < assembly.triangleCount(); ++t)
		for (int corner = 0; corner < 3; ++corner) {
			if (assembly.triangleCopies(corner, t) != copy)
				continue;
			const auto p = assembly.trianglePlaces.col(t), c = assembly.triangleCopies.col(t);
			const AngleGradients gradients(
				TriangleFrame(positions.col(p[0]), positions.col(p[1]), positions.col(p[2])));
			derivative -=
				2 * gradients.weighted(Eigen::Vector3d(g[c[0]], g[c[1]], g[c[2]]), corner).dot(normal);
		}
	return derivative;
}

/// The paper's algorithm, where every angle defect is computed anew after every move, the worst vertex is
/// found by looking at all, and the lowest state is a copy. On three things the paper is silent: a vertex
/// whose δ does not change is set aside until a neighbour moves; the state of lowest G is returned; a run
/// that has found no lower G within 20 operations a movable vertex ends.
/// \param maxDisplacement  δ_T, length
/// \return                 the number of operations
inline long slowLocalMethod(const PatchAssembly& assembly, Positions& positions, double angleTolerance,
							double maxDisplacement, long maxOperations) {
	const Positions start = positions;
	const Eigen::Matrix3Xd normals = copyNormals(assembly, start);
	Eigen::VectorXd height = Eigen::VectorXd::Zero(assembly.copyCount()),
					g = angleDefects(assembly, positions);
	std::vector<char> movable(assembly.copyCount()), setAside(assembly.copyCount(), 0);
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		movable[copy] = assembly.copyInterior[copy] &&
						!assembly.placeAssembling[assembly.placeOfCopy[copy]] &&
						!assembly.placeFixed[assembly.placeOfCopy[copy]];
	const long patience = 20 * std::count(movable.begin(), movable.end(), 1);
	double now = detectFunction(g), lowest = now;
	Positions lowestPositions = positions;
	long operations = 0, lowestAt = 0;
	for (; operations < maxOperations && operations - lowestAt <= patience; ++operations) {
		int worst = -1;
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			if (movable[copy] && !setAside[copy] && (worst < 0 || g[copy] * g[copy] > g[worst] * g[worst]))
				worst = copy;
		if (worst < 0 || g[worst] * g[worst] <= angleTolerance * angleTolerance)
			break;
		const std::vector<int> star = starOf(assembly, worst);
		double value = 0;
		for (const int copy : star)
			value += g[copy] * g[copy];
		const double step = -value / slowDerivative(assembly, positions, g, normals.col(worst), worst);
		const double wanted = std::clamp(height[worst] + step, -maxDisplacement, maxDisplacement);
		if (!std::isfinite(step) || wanted == height[worst]) {
			setAside[worst] = 1;
			continue;
		}
		height[worst] = wanted;
		const int place = assembly.placeOfCopy[worst];
		positions.col(place) = start.col(place) + wanted * normals.col(worst);
		const Eigen::VectorXd before = g;
		g = angleDefects(assembly, positions);
		for (const int copy : star) {
			now += g[copy] * g[copy] - before[copy] * before[copy];
			setAside[copy] = 0;
		}
		if (now < lowest) {
			lowest = now;
			lowestPositions = positions;
			lowestAt = operations + 1;
		}
	}
	positions = lowestPositions;
	return operations;
}

} // namespace developable::test
