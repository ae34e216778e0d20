// SPDX-License-Identifier: GPL-3.0-or-later
// Every method, with one allocation after the other failing: it ends as std::bad_alloc with what it was given
// untouched, or, where it could do without, with the same result to the last bit.
#include "failing_allocator.h"

#include "developable/bounded_strain/bounded_strain.h"
#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/linear/linear.h"
#include "developable/local/local_method.h"
#include "developable/newton/constrained_newton.h"
#include "developable/panels/cut_into_panels.h"
#include "developable/penalty/penalty_method.h"
#include "developable/polygons/polygon_triangulation.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>

namespace developable::test {
namespace {

/// Numbers that say all of a result.
using Outcome = Eigen::VectorXd;

Outcome numbersOf(const Positions& positions, Status status) {
	Outcome numbers(positions.size() + 1);
	numbers << positions.reshaped(), static_cast<double>(status);
	return numbers;
}

/// Of a method's many allocations so many are made to fail, from the first to the last.
constexpr long mostSteps = 120;

/// A method at work: what it is given and what it comes to.
struct Work {
	std::function<void()> run;                             ///< allocations fail in here only
	std::function<Outcome()> outcome;                      ///< of a run that has come to its end
	std::function<bool()> untouched = [] { return true; }; ///< whether what it was given is as it was
};

/// \return whether the run came to its end
bool comesToItsEnd(const Work& work, const Outcome& expected, const FailingAllocations& fails) {
	arm(fails);
	try {
		work.run();
	} catch (const std::bad_alloc&) {
		disarm();
		EXPECT_TRUE(work.untouched()) << "allocation " << fails.first;
		return false;
	} catch (const std::exception& error) {
		disarm();
		ADD_FAILURE() << "allocation " << fails.first << ": " << error.what();
		return false;
	}
	disarm();
	EXPECT_EQ(work.outcome(), expected) << "allocation " << fails.first;
	return true;
}

void expectFailedAllocationsAreTold(const Work& work) {
	work.run();
	const Outcome expected = work.outcome();
	arm({});
	work.run();
	const long allocations = disarm();
	ASSERT_EQ(work.outcome(), expected);
	ASSERT_GT(allocations, 0);
	const long stride = allocations / mostSteps + 1;
	long told = 0;
	for (long first = 1; first <= allocations && !testing::Test::HasFailure(); first += stride)
		for (const long count : {1L, allocations}) // a single one, or all from then on
			told += !comesToItsEnd(work, expected, {first, count});
	EXPECT_GT(told, allocations / stride);
	EXPECT_TRUE(comesToItsEnd(work, expected, {4 * allocations, 1}));
}

/// Of a method that moves the places of an assembly.
template <class Method>
void expectFailedAllocationsAreTold(const PatchAssembly& assembly, const Method& method) {
	Positions positions = assembly.originalPositions;
	Status status = Status::NothingToDo;
	Work work;
	work.run = [&] {
		positions = assembly.originalPositions;
		status = method(positions);
	};
	work.outcome = [&] { return numbersOf(positions, status); };
	work.untouched = [&] { return positions == assembly.originalPositions; };
	work.run();
	ASSERT_FALSE(work.untouched());
	expectFailedAllocationsAreTold(work);
}

PatchAssembly smallPanels() {
	TriangleMesh right = jitteredGrid(7, 7, saddle);
	right.positions.row(0) = 2 - right.positions.row(0).array();
	TriangleMesh third = jitteredGrid(6, 6, wave);
	third.positions.row(2).array() += 5;
	return assembled(together(together(jitteredGrid(7, 7, saddle), right), third));
}

Status newton(const PatchAssembly& assembly, Positions& positions, ConstrainedNewtonOptions options) {
	options.maxIterations = 12;
	return constrainedNewton(assembly, positions, options).status;
}

TEST(FailedAllocations, OfConstrainedNewton) {
	const PatchAssembly assembly = smallPanels();
	for (const int threads : {1, 2}) {
		ConstrainedNewtonOptions options;
		options.threads = threads;
		expectFailedAllocationsAreTold(
			assembly, [&](Positions& positions) { return newton(assembly, positions, options); });
	}
}

TEST(FailedAllocations, OfConstrainedNewtonOnLevels) {
	const PatchAssembly assembly = assembled(jitteredGrid(10, 10, bumpedCylinder));
	ConstrainedNewtonOptions options;
	options.tuning.coarsest = 30;
	options.fairness = 0.2;
	expectFailedAllocationsAreTold(
		assembly, [&](Positions& positions) { return newton(assembly, positions, options); });
}

TEST(FailedAllocations, OfConstrainedNewtonByIteration) {
	const PatchAssembly assembly = assembled(jitteredGrid(7, 7, wave));
	ConstrainedNewtonOptions options;
	options.memoryLimit = 1;
	expectFailedAllocationsAreTold(
		assembly, [&](Positions& positions) { return newton(assembly, positions, options); });
}

TEST(FailedAllocations, OfThePenaltyMethod) {
	const PatchAssembly assembly = smallPanels();
	PenaltyMethodOptions options;
	options.maxIterations = 5;
	expectFailedAllocationsAreTold(
		assembly, [&](Positions& positions) { return penaltyMethod(assembly, positions, options).status; });
}

TEST(FailedAllocations, OfTheLocalMethod) {
	const PatchAssembly assembly = smallPanels();
	LocalMethodOptions options;
	options.maxOperations = 500;
	for (const bool intersections : {false, true}) {
		options.avoidSelfIntersections = intersections;
		expectFailedAllocationsAreTold(
			assembly, [&](Positions& positions) { return localMethod(assembly, positions, options).status; });
	}
}

TEST(FailedAllocations, OfBoundedStrain) {
	const PatchAssembly assembly = assembled(jitteredGrid(7, 7, sphereCap(1)));
	BoundedStrainOptions options;
	options.bounds.warp = options.bounds.weft = options.bounds.bias = {0.01, 0.01};
	options.maxIterations = 4;
	expectFailedAllocationsAreTold(
		assembly, [&](Positions& positions) { return boundedStrain(assembly, positions, options).status; });
}

TEST(FailedAllocations, OfFlattening) {
	const PatchAssembly assembly = smallPanels();
	FlatPatterns patterns;
	Work work;
	work.run = [&] { patterns = flattenPatches(assembly, assembly.originalPositions, {}); };
	work.outcome = [&]() -> Outcome { return patterns.positions.reshaped(); };
	expectFailedAllocationsAreTold(work);
}

TEST(FailedAllocations, OfCuttingIntoPanels) {
	const TriangleMesh mesh = sphere(1, 1);
	CutOptions options;
	options.maxDisplacement = 0.2;
	CutResult result;
	Work work;
	work.run = [&] { result = cutIntoPanels(mesh, PatchOptions(), options, {}); };
	work.outcome = [&] {
		Outcome numbers(result.mesh.triangles.size() + 2);
		numbers << result.mesh.triangles.reshaped().cast<double>(), result.report.seamLength,
			static_cast<double>(result.report.status);
		return numbers;
	};
	expectFailedAllocationsAreTold(work);
}

TEST(FailedAllocations, OfReadingAndMeasuring) {
	const TriangleMesh mesh = together(jitteredGrid(7, 7, saddle), jitteredGrid(5, 5, wave));
	const Positions above = mesh.positions.array() + 0.1;
	PrincipalCurvatures curvatures;
	Eigen::VectorXd defects, distances;
	Work work;
	work.run = [&] {
		const PatchAssembly assembly = assembled(mesh);
		curvatures = principalCurvatures(assembly, assembly.originalPositions);
		defects = angleDefects(assembly, assembly.originalPositions);
		distances = distancesToSurface(above, assembly.originalPositions, assembly.trianglePlaces);
	};
	work.outcome = [&] {
		Outcome numbers(curvatures.least.size() + curvatures.greatest.size() + defects.size() +
						distances.size());
		numbers << curvatures.least, curvatures.greatest, defects, distances;
		return numbers;
	};
	expectFailedAllocationsAreTold(work);
}

TEST(FailedAllocations, OfTriangulatingAPolygon) {
	Positions star = Positions::Zero(3, 20);
	for (int i = 0; i < star.cols(); ++i)
		star.col(i) << (1 + i % 2) * std::cos(i * pi / 10), (1 + i % 2) * std::sin(i * pi / 10), 0;
	Eigen::Matrix3Xi triangles;
	Work work;
	work.run = [&] { triangles = triangulatePolygon(star).value(); };
	work.outcome = [&]() -> Outcome { return triangles.reshaped().cast<double>(); };
	expectFailedAllocationsAreTold(work);
}

} // namespace
} // namespace developable::test
