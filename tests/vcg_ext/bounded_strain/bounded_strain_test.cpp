// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/bounded_strain/bounded_strain.h"
#include "developable/newton/constrained_newton.h"

#include "spherical_cap.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

BoundedStrainOptions optionsFor(double stretch, double compression) {
	BoundedStrainOptions options;
	options.bounds = StrainBounds::isotropic(stretch, compression);
	return options;
}

FlatPatterns patternsOf(const PatchAssembly& assembly, const Positions& positions,
						const StrainBounds& bounds) {
	FlattenOptions options;
	options.bounds = bounds;
	return flattenPatches(assembly, positions, options);
}

/// Singular values by Eigen from the triangles of both meshes, and nothing of the library's own.
Eigen::Array2d extremeStrains(const PatchAssembly& assembly, const Positions& positions,
							  const FlatPatterns& patterns) {
	Eigen::Array2d extreme(-1, -1);
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const Eigen::Matrix3d x = positions(Eigen::all, assembly.trianglePlaces.col(t));
		const Eigen::Matrix<double, 2, 3> u = patterns.positions(Eigen::all, patterns.triangles.col(t));
		Eigen::Matrix<double, 3, 2> shaped;
		Eigen::Matrix2d flat;
		shaped << x.col(1) - x.col(0), x.col(2) - x.col(0);
		flat << u.col(1) - u.col(0), u.col(2) - u.col(0);
		const Eigen::MatrixXd map = shaped * flat.inverse();
		const Eigen::Vector2d values = Eigen::JacobiSVD<Eigen::MatrixXd>(map).singularValues();
		extreme = extreme.max(Eigen::Array2d(values[0] - 1, 1 - values[1]));
	}
	return extreme;
}

double distance(const PatchAssembly& assembly, const Positions& positions) {
	const SparseMatrix metric = displacementMetric(assembly, BoundedStrainOptions().smoothness);
	const Eigen::MatrixXd d = (positions - assembly.originalPositions).transpose();
	return std::sqrt(d.cwiseProduct(metric.selfadjointView<Eigen::Lower>() * d).sum());
}

constexpr double capAngle = 0.4;
constexpr double equalBounds = capAngle * capAngle / 12, oneBound = capAngle * capAngle / 6;

TEST(BoundedStrain, ACapStaysWhereItsMaterialBearsWhatTheSphereAsksFor) {
	const PatchAssembly assembly = assembled(sphericalCap(capAngle, 8));
	const double bounds[][2] = {
		{1.06 * equalBounds, 1.06 * equalBounds}, {1.1 * oneBound, 0}, {0, 1.1 * oneBound}};
	for (const auto& [stretch, compression] : bounds) {
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report =
			boundedStrain(assembly, positions, optionsFor(stretch, compression));
		EXPECT_EQ(report.status, Status::NothingToDo) << stretch << ' ' << compression;
		EXPECT_TRUE(positions == assembly.originalPositions);
	}
}

TEST(BoundedStrain, ACapMovesWhereItBearsLess) {
	const PatchAssembly assembly = assembled(sphericalCap(capAngle, 8));
	const double bounds[][2] = {
		{0.9 * equalBounds, 0.9 * equalBounds}, {0.9 * oneBound, 0}, {0, 0.9 * oneBound}};
	for (const auto& [stretch, compression] : bounds) {
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report =
			boundedStrain(assembly, positions, optionsFor(stretch, compression));
		EXPECT_EQ(report.status, Status::Converged) << stretch << ' ' << compression;
		EXPECT_GT(distance(assembly, positions), 1e-4);
		const FlatPatterns patterns =
			patternsOf(assembly, positions, StrainBounds::isotropic(stretch, compression));
		const Eigen::Array2d strains = extremeStrains(assembly, positions, patterns);
		EXPECT_LT(strains[0], stretch + 1e-4);
		EXPECT_LT(strains[1], compression + 1e-4);
		EXPECT_NEAR(std::max(strains[0], 0.0), patterns.report.maxStretch, 1e-9);
		EXPECT_NEAR(std::max(strains[1], 0.0), patterns.report.maxCompression, 1e-9);
	}
}

TEST(BoundedStrain, WhatIsNearlyWithinItsBoundsIsMovedOntoThemAndNoFarther) {
	const PatchAssembly assembly = assembled(sphericalCap(capAngle, 8));
	for (const double share : {0.98, 0.9}) {
		const double bound = share * equalBounds;
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report = boundedStrain(assembly, positions, optionsFor(bound, bound));
		ASSERT_EQ(report.status, Status::Converged) << share;
		const Eigen::Array2d strains =
			extremeStrains(assembly, positions, patternsOf(assembly, positions, report.patterns.bounds));
		EXPECT_GT(strains.maxCoeff(), bound - 1e-5) << share;
		EXPECT_NEAR(strains[0], report.patterns.report.maxStretch, 1e-9);
		EXPECT_NEAR(strains[1], report.patterns.report.maxCompression, 1e-9);
	}
}

TEST(BoundedStrain, RunsEndWherePlacesAreTooFarOnAverage) {
	const PatchAssembly assembly = assembled(sphericalCap(capAngle, 8));
	BoundedStrainOptions options = optionsFor(0.5 * equalBounds, 0.5 * equalBounds);
	options.severalStarts = false;
	options.searchBeyond = false;
	Positions nearest = assembly.originalPositions;
	const BoundedStrainReport whole = boundedStrain(assembly, nearest, options);
	ASSERT_EQ(whole.status, Status::Converged);
	const double mean = displacementMap(assembly.originalPositions, nearest).mean();
	for (const double share : {0.3, 20.0}) {
		options.meanOnWay = share * mean;
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report = boundedStrain(assembly, positions, options);
		if (share > 1) {
			EXPECT_TRUE(positions == nearest);
			continue;
		}
		EXPECT_EQ(report.status, Status::NeedsCut);
		EXPECT_GT(report.beyondBounds, patternTolerance);
		EXPECT_LT(report.iterations, whole.iterations);
		EXPECT_GT(displacementMap(assembly.originalPositions, positions).mean(), options.meanOnWay);
	}
}

TEST(BoundedStrain, WarpAndWeftHaveBoundsOfTheirOwn) {
	const PatchAssembly assembly = assembled(sphericalCap(capAngle, 8));
	BoundedStrainOptions options = optionsFor(0.9 * equalBounds, 0.9 * equalBounds);
	Positions tight = assembly.originalPositions;
	boundedStrain(assembly, tight, options);
	// What gives more across the grain stays nearer, whichever way the grain runs.
	options.bounds.directed = true;
	options.bounds.weft = {2 * equalBounds, 2 * equalBounds};
	for (const Grain::Choice grain : {Grain::XAxis, Grain::YAxis}) {
		options.grain = grain;
		Positions positions = assembly.originalPositions;
		ASSERT_TRUE(converged(boundedStrain(assembly, positions, options).status));
		EXPECT_LT(distance(assembly, positions), distance(assembly, tight));
		FlattenOptions flattening;
		flattening.bounds = options.bounds;
		flattening.grain = grain;
		EXPECT_LT(flattenPatches(assembly, positions, flattening).report.beyondBounds, patternTolerance);
	}
}

TEST(BoundedStrain, DirectedBoundsAreKeptWhicheverWayTheGrainRuns) {
	// Nothing here is symmetric, so that every strain would like to turn the pattern against its grain.
	const PatchAssembly assembly = assembled(grid(13, 9, [](double u, double v) {
		return Eigen::Vector3d(1.4 * u + 0.2 * v, v, 0.4 * std::exp(-9 * (u - 0.4) * (u - 0.4) - 12 * v * v));
	}));
	BoundedStrainOptions options;
	options.bounds.directed = true;
	options.bounds.warp = {0.003, 0.003};
	options.bounds.weft = {0.03, 0.03};
	options.bounds.bias = {0.01, 0.01};
	options.severalStarts = false; // so that the steps are those of one run
	const Grain grains[] = {Grain::LongestSeam, Grain::XAxis, Grain(Eigen::Vector3d(1, 2, 0.5))};
	for (const Grain& grain : grains) {
		options.grain = grain;
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report = boundedStrain(assembly, positions, options);
		EXPECT_EQ(report.status, Status::Converged) << grain.direction().transpose();
		EXPECT_LT(report.iterations, 60) << grain.direction().transpose();
		EXPECT_GT(distance(assembly, positions), 1e-4);
	}
}

TEST(BoundedStrain, TheGrainTurnsWithTheModel) {
	const Eigen::Matrix3d turn =
		Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
	TriangleMesh mesh = grid(11, 9, [](double u, double v) {
		return Eigen::Vector3d(1.4 * u, v, 0.3 * std::exp(-9 * (u - 0.4) * (u - 0.4) - 12 * v * v));
	});
	const PatchAssembly upright = assembled(mesh);
	mesh.positions = turn * mesh.positions;
	const PatchAssembly turned = assembled(mesh);
	BoundedStrainOptions options;
	options.bounds.directed = true;
	options.bounds.warp = {0.003, 0.003};
	options.bounds.weft = options.bounds.bias = {0.02, 0.02};
	double distances[2]; // along x, and along the direction at 45 degrees
	for (const int bias : {0, 1}) {
		const Eigen::Vector3d grain(1, bias, 0);
		Positions here = upright.originalPositions, there = turned.originalPositions;
		options.grain = Grain(grain);
		ASSERT_TRUE(converged(boundedStrain(upright, here, options).status));
		options.grain = Grain(Eigen::Vector3d(turn * grain));
		ASSERT_TRUE(converged(boundedStrain(turned, there, options).status));
		distances[bias] = distance(upright, here);
		EXPECT_NEAR(distance(turned, there) / distances[bias], 1, 0.01);
		const auto apart = [&] {
			return (there - turn * here).colwise().norm().maxCoeff() / distances[bias];
		};
		EXPECT_LT(apart(), bias ? 0.2 : 0.1);
		if (bias)
			continue;
		there = turned.originalPositions;
		options.grain = Grain(grain); // did not turn
		ASSERT_TRUE(converged(boundedStrain(turned, there, options).status));
		EXPECT_GT(apart(), 1);
	}
	EXPECT_GT(std::abs(distances[1] / distances[0] - 1), 0.05);
}

TEST(BoundedStrain, MovesLessTheMoreIsAllowedAndNeverFartherThanToADevelopableShape) {
	const PatchAssembly assembly = assembled(jitteredGrid(17, 17, sphereCap(1)));
	Positions developable = assembly.originalPositions;
	constrainedNewton(assembly, developable, {});
	double before = distance(assembly, developable);
	for (const double bound : {0.002, 0.005, 0.01, 0.02}) {
		Positions positions = assembly.originalPositions;
		const BoundedStrainReport report = boundedStrain(assembly, positions, optionsFor(bound, bound));
		EXPECT_TRUE(converged(report.status)) << bound;
		EXPECT_LT(distance(assembly, positions), before) << bound;
		before = distance(assembly, positions);
	}
}

TEST(BoundedStrain, ADevelopableSurfaceStaysUnderAnyBound) {
	const PatchAssembly assembly = assembled(grid(17, 17, quarterCylinder));
	for (const auto& options : {optionsFor(0.001, 0), optionsFor(0, 0.001), optionsFor(0.05, 0.05)}) {
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::NothingToDo);
		EXPECT_TRUE(positions == assembly.originalPositions);
	}
}

TEST(BoundedStrain, SewnPanelsStaySewnAndEachIsWithinItsBounds) {
	TriangleMesh left = grid(11, 11, largeSaddle), right = left;
	right.positions.row(0) = 2 - left.positions.row(0).array();
	right.triangles.row(1).swap(right.triangles.row(2));
	const PatchAssembly assembly = assembled(together(left, right));
	ASSERT_EQ(assembly.placeCount(), 2 * 121 - 11);
	Positions positions = assembly.originalPositions;
	const StrainBounds bounds = StrainBounds::isotropic(0.03, 0.03);
	BoundedStrainOptions options;
	options.bounds = bounds;
	EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::Converged);
	const FlatPatterns patterns = patternsOf(assembly, positions, bounds);
	ASSERT_EQ(patterns.pieces.size(), 2u);
	EXPECT_LT(extremeStrains(assembly, positions, patterns).maxCoeff(), 0.03 + 1e-4);
	ASSERT_EQ(patterns.seams.size(), 1u);
	EXPECT_LT(patterns.report.maxSeamMismatch, 0.06 * patterns.seams[0].length[0]);
}

TEST(BoundedStrain, ResultMovesAndScalesWithTheInput) {
	const TriangleMesh mesh = sphericalCap(0.5, 7);
	TriangleMesh other = mesh;
	other.positions = moved(mesh.positions, 20, Eigen::Vector3d(3, -4, 5));
	const PatchAssembly first = assembled(mesh), second = assembled(other);
	Positions a = first.originalPositions, b = second.originalPositions;
	boundedStrain(first, a, optionsFor(0.01, 0.01));
	boundedStrain(second, b, optionsFor(0.01, 0.01));
	EXPECT_NEAR(distance(second, b) / (20 * distance(first, a)), 1, 0.01);
}

TEST(BoundedStrain, NoPlaceGoesFartherThanItMayAndTheVerdictSaysSo) {
	const PatchAssembly assembly = assembled(sphericalCap(0.5, 8));
	BoundedStrainOptions options = optionsFor(0.005, 0.005);
	Positions free = assembly.originalPositions;
	ASSERT_EQ(boundedStrain(assembly, free, options).status, Status::Converged);
	const auto farthest = [&](const Positions& positions) {
		return (positions - assembly.originalPositions).colwise().norm().maxCoeff();
	};
	options.maxDisplacement = 0.6 * farthest(free); // another shape within the same bounds is near enough
	Positions within = assembly.originalPositions;
	EXPECT_EQ(boundedStrain(assembly, within, options).status, Status::Converged);
	EXPECT_LE(farthest(within), options.maxDisplacement);
	EXPECT_GT(distance(assembly, within), distance(assembly, free));
	EXPECT_LT(extremeStrains(assembly, within, patternsOf(assembly, within, options.bounds)).maxCoeff(),
			  0.005 + 1e-4);
	options.maxDisplacement = 0.2 * farthest(free); // none is
	Positions beyond = assembly.originalPositions;
	const BoundedStrainReport report = boundedStrain(assembly, beyond, options);
	EXPECT_EQ(report.status, Status::NeedsCut);
	EXPECT_EQ(report.reason, Reason::TooFar);
	EXPECT_NEAR(report.nearestDevelopable, farthest(free), 1e-2 * farthest(free));
	EXPECT_LE(farthest(beyond), options.maxDisplacement);
	options.maxDisplacement = 0;
	Positions still = assembly.originalPositions;
	EXPECT_EQ(boundedStrain(assembly, still, options).status, Status::NeedsCut);
	EXPECT_TRUE(still == assembly.originalPositions);
}

TEST(BoundedStrain, FairnessSmoothsWavesAway) {
	TriangleMesh mesh = sphericalCap(0.5, 8);
	std::mt19937 random(5);
	for (double& height : mesh.positions.row(2))
		height += 0.01 * (2.0 * random() / std::mt19937::max() - 1);
	const PatchAssembly assembly = assembled(mesh);
	const SparseMatrix metric = displacementMetric(assembly, 1);
	const auto bending = [&](const Positions& positions) {
		const Eigen::MatrixXd x = positions.transpose();
		return x.cwiseProduct(metric.selfadjointView<Eigen::Lower>() * x).sum();
	};
	double before = std::numeric_limits<double>::infinity();
	for (const double fairness : {0.0, 0.3, 0.8}) {
		BoundedStrainOptions options = optionsFor(0.01, 0.01);
		options.fairness = fairness;
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::Converged) << fairness;
		EXPECT_LT(bending(positions), before) << fairness;
		before = bending(positions);
	}
}

TEST(BoundedStrain, LargePartsAreSolvedFromCoarseToFineAndSeveralOnAnyNumberOfThreads) {
	TriangleMesh large = jitteredGrid(51, 51, sphereCap(1)), small = sphericalCap(0.5, 7);
	small.positions.row(0).array() += 5;
	const PatchAssembly assembly = assembled(together(large, small));
	BoundedStrainOptions options = optionsFor(0.01, 0.01);
	Positions results[2] = {assembly.originalPositions, assembly.originalPositions};
	for (const int threads : {1, 2}) {
		options.threads = threads;
		const BoundedStrainReport report = boundedStrain(assembly, results[threads - 1], options);
		EXPECT_EQ(report.status, Status::Converged);
		ASSERT_EQ(report.patchVerdicts.size(), 2u);
		EXPECT_EQ(report.patchVerdicts[0].status, Status::Converged);
	}
	EXPECT_TRUE(results[0] == results[1]);
	const FlatPatterns patterns = patternsOf(assembly, results[0], options.bounds);
	EXPECT_LT(extremeStrains(assembly, results[0], patterns).maxCoeff(), 0.01 + 1e-4);
}

TEST(BoundedStrain, HasTheSameBitsOnEveryRun) {
	const PatchAssembly assembly = assembled(sphericalCap(0.5, 7));
	Positions results[2] = {assembly.originalPositions, assembly.originalPositions};
	for (Positions& positions : results)
		boundedStrain(assembly, positions, optionsFor(0.01, 0.005));
	EXPECT_TRUE(results[0] == results[1]);
}

TEST(BoundedStrain, HeldPlacesStay) {
	TriangleMesh mesh = sphericalCap(0.5, 8);
	mesh.vertexSelected[0] = mesh.vertexSelected[1] = 1;
	PatchOptions fixing;
	fixing.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, fixing);
	Positions positions = assembly.originalPositions;
	const BoundedStrainReport report = boundedStrain(assembly, positions, optionsFor(0.015, 0.015));
	EXPECT_EQ(report.status, Status::Converged);
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (assembly.placeFixed[place]) {
			EXPECT_EQ(positions.col(place), assembly.originalPositions.col(place));
		}
}

double distanceOf(const PatchAssembly& assembly, double bound, double smoothness, bool severalStarts) {
	BoundedStrainOptions options = optionsFor(bound, bound);
	options.smoothness = smoothness;
	options.severalStarts = severalStarts;
	Positions positions = assembly.originalPositions;
	EXPECT_EQ(boundedStrain(assembly, positions, options).status, Status::Converged);
	const Eigen::Array2d strains =
		extremeStrains(assembly, positions, patternsOf(assembly, positions, options.bounds));
	EXPECT_LT(strains.maxCoeff(), bound + 1e-4);
	return std::sqrt(nearness(assembly, smoothness, 0).squaredDistance(positions));
}

TEST(BoundedStrain, OfSeveralWaysTheNearestResultCounts) {
	const Surface dome = [](double u, double v) {
		return Eigen::Vector3d(u, v, -0.5 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
	};
	const Surface waves = [](double u, double v) {
		return Eigen::Vector3d(u, 1.3 * v, 0.07 * std::sin(6 * u + v) * std::cos(4 * v));
	};
	for (const Surface& surface : {dome, waves})
		for (const double smoothness : {1e-9, 3e-6}) {
			const PatchAssembly assembly = assembled(jitteredGrid(13, 13, surface, 0.15));
			EXPECT_LE(distanceOf(assembly, 0.005, smoothness, true),
					  distanceOf(assembly, 0.005, smoothness, false));
		}
	// Without bending, soft bounds alone lead to waves that are a third farther than they have to be.
	const PatchAssembly fine = assembled(grid(15, 15, dome));
	EXPECT_LT(distanceOf(fine, 0.005, 1e-9, true), 0.8 * distanceOf(fine, 0.005, 1e-9, false));
}

TEST(BoundedStrain, ChangesNothingWhenItIsStoppedOrRefuses) {
	const PatchAssembly assembly = assembled(sphericalCap(0.5, 7));
	Positions positions = assembly.originalPositions;
	int calls = 0;
	const Progress stopLater = [&](double, const std::string&) { return ++calls < 15; };
	EXPECT_EQ(boundedStrain(assembly, positions, optionsFor(0.01, 0.01), stopLater).status, Status::Stopped);
	EXPECT_TRUE(positions == assembly.originalPositions);
	EXPECT_THROW(boundedStrain(assembly, positions, optionsFor(-1, 0)), InvalidParameter);
	EXPECT_THROW(boundedStrain(assembly, positions, optionsFor(0, 1)), InvalidParameter);
	EXPECT_THROW(boundedStrain(assembly, positions, optionsFor(0, 0)), InvalidParameter);
	for (double BoundedStrainOptions::*option :
		 {&BoundedStrainOptions::fairness, &BoundedStrainOptions::maxDisplacement,
		  &BoundedStrainOptions::smoothness, &BoundedStrainOptions::tolerance,
		  &BoundedStrainOptions::meanOnWay}) {
		BoundedStrainOptions options = optionsFor(0.01, 0.01);
		options.*option = std::nan("");
		EXPECT_THROW(boundedStrain(assembly, positions, options), InvalidParameter);
	}
	const PatchAssembly closed = assembled(octahedron());
	Positions ofClosed = closed.originalPositions;
	EXPECT_THROW(boundedStrain(closed, ofClosed, optionsFor(0.1, 0.1)), ClosedPatch);
	EXPECT_TRUE(positions == assembly.originalPositions);
	EXPECT_TRUE(ofClosed == closed.originalPositions);
}

} // namespace
} // namespace developable::test
