// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/local_method.h"

#include "developable/mesh_reader.h"
#include "developable/roughness.h"
#include "support/finite_differences.h"
#include "support/shapes.h"
#include "support/slow_local_method.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

Measures measured(const PatchAssembly& assembly, const Positions& positions) {
	return measure(assembly, positions, 1e-4);
}

/// A cap that the paper's method does not finish.
PatchAssembly hardCase() {
	return assembled(jitteredGrid(11, 11, sphereCap(1.0)));
}

TEST(LocalState, DerivativeOfTAgreesWithDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(7, 7, bumpedCylinder));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	const double step = 1e-6;
	for (int place = 0; place < assembly.placeCount(); ++place) {
		if (!state.mesh().movable(place))
			continue;
		const double derivative = state.localDerivative(place);
		state.moveTo(place, step);
		const double above = state.localDetectFunction(place);
		state.moveTo(place, -step);
		const double below = state.localDetectFunction(place);
		state.moveTo(place, 0);
		EXPECT_NEAR(derivative, (above - below) / (2 * step), 1e-6 * std::max(1.0, std::abs(derivative)));
	}
}

TEST(LocalState, DerivativeOfTheUnevennessAgreesWithDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(6, 6, bumpedCylinder));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (state.mesh().movable(place))
			state.moveTo(place, 0.01 * (place % 7 - 3));
	const auto& order = state.mesh().originalPlace;
	const int place = static_cast<int>(std::find(order.begin(), order.end(), 14) - order.begin());
	const double height = state.height(place), derivative = state.unevennessDerivative(place);
	state.moveTo(place, height + 1e-5);
	const double above = state.unevenness(place);
	state.moveTo(place, height - 1e-5);
	EXPECT_NEAR(derivative, (above - state.unevenness(place)) / 2e-5, 1e-9);
	EXPECT_GT(std::abs(derivative), 1e-3);
}

TEST(LocalState, KeepsAngleDefectsEqualToANewComputation) {
	const PatchAssembly assembly = assembled(jitteredGrid(8, 8, saddle));
	detail::LocalState state(assembly, assembly.originalPositions, AssemblingVertices::Fixed);
	for (int place = 0; place < assembly.placeCount(); place += 3)
		if (state.mesh().movable(place))
			state.moveTo(place, 0.01 * (place % 5 - 2));
	EXPECT_EQ(state.defects(), angleDefects(assembly, state.positions()));
	EXPECT_NEAR(state.detectFunction(), detectFunction(state.defects()), 1e-12);
}

TEST(LocalMethod, NeverEndsWithALargerDetectFunction) {
	for (const int size : {6, 13, 21})
		for (const Surface& surface :
			 {Surface(bumpedCylinder), Surface(saddle), sphereCap(1.0), sphereCap(0.72)})
			for (const double displacement : {-1.0, 0.001, 0.1}) {
				const PatchAssembly assembly = assembled(jitteredGrid(size, size, surface));
				Positions positions = assembly.originalPositions;
				LocalMethodOptions options;
				options.maxDisplacement = displacement;
				options.maxOperations = 20000;
				localMethod(assembly, positions, options);
				EXPECT_LE(measured(assembly, positions).detectFunction,
						  measured(assembly, assembly.originalPositions).detectFunction);
			}
}

TEST(LocalMethod, MovesInnerVerticesAlongTheirNormalsWithinTheTolerance) {
	const PatchAssembly assembly = assembled(jitteredGrid(14, 14, bumpedCylinder));
	const Eigen::Matrix3Xd normals = detail::copyNormals(assembly, assembly.originalPositions);
	LocalMethodOptions options;
	options.maxDisplacement = 0.004;
	Positions positions = assembly.originalPositions;
	localMethod(assembly, positions, options);
	double largest = 0;
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		const int place = assembly.placeOfCopy[copy];
		const Eigen::Vector3d move = positions.col(place) - assembly.originalPositions.col(place);
		if (!assembly.copyInterior[copy]) {
			EXPECT_EQ(move.norm(), 0);
		}
		EXPECT_LT(move.cross(normals.col(copy)).norm(), 1e-15);
		EXPECT_LE(move.norm(), options.maxDisplacement * (1 + 1e-12));
		largest = std::max(largest, move.norm());
	}
	EXPECT_NEAR(largest, options.maxDisplacement, 1e-12); // the clamp was at work
}

TEST(LocalMethod, RepairsADentInASheet) {
	TriangleMesh mesh = grid(9, 9, flatSheet);
	mesh.positions(2, 40) = 0.02; // the middle
	const PatchAssembly assembly = assembled(mesh);
	Positions positions = assembly.originalPositions;
	LocalMethodOptions options;
	options.angleTolerance = 0.01;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Converged);
	EXPECT_EQ(report.reason, Reason::AsStatus);
	EXPECT_LE(measured(assembly, positions).maxAngleDefect, 0.01);
	EXPECT_GT(measured(assembly, assembly.originalPositions).maxAngleDefect, 0.01);
}

TEST(LocalMethod, FirstMoveIsThatOfEq19) {
	// One movable vertex: T = g², T' = 2 g g', so the first step is −g / (2 g').
	Positions positions(3, 5);
	positions << 0, 1, 0, -1, 0, 0, 0, 1, 0, -1, 0.3, 0, 0, 0, 0;
	Eigen::Matrix3Xi triangles(3, 4);
	triangles << 0, 0, 0, 0, 1, 2, 3, 4, 2, 3, 4, 1;
	const PatchAssembly assembly = assembled(makeMesh(positions, triangles));
	const auto defectAt = [&](double height) {
		Positions at = positions;
		at(2, 0) = height;
		return angleDefects(assembly, at)[0];
	};
	const double slope = (defectAt(0.3 + 1e-6) - defectAt(0.3 - 1e-6)) / 2e-6;
	LocalMethodOptions options;
	options.maxOperations = 1;
	Positions result = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, result, options);
	EXPECT_EQ(report.iterations, 1);
	EXPECT_EQ(report.status, Status::LimitReached);
	EXPECT_NEAR(result(2, 0), 0.3 - defectAt(0.3) / (2 * slope), 1e-9);
}

TEST(LocalMethod, HoldsAssemblingVerticesAndImprovesThemThroughTheirNeighbours) {
	// A second sheet's corner is sewn to an inner vertex of the first: that place has a copy of its own in
	// each.
	TriangleMesh sheet = grid(11, 11, flatSheet);
	sheet.positions(2, 60) = 0.03;
	const TriangleMesh flap = grid(4, 4, [&](double u, double v) -> Eigen::Vector3d {
		return sheet.positions.col(60) + Eigen::Vector3d(u, v, 2 * (u + v));
	});
	const PatchAssembly assembly = assembled(together(sheet, flap));
	ASSERT_EQ(assembly.assemblingPlaceCount(), 1);
	Positions positions = assembly.originalPositions;
	localMethod(assembly, positions, {});
	EXPECT_EQ(positions.col(60), assembly.originalPositions.col(60));
	const double before = angleDefects(assembly, assembly.originalPositions)[60];
	EXPECT_GT(std::abs(before), 1e-3);
	EXPECT_LT(std::abs(angleDefects(assembly, positions)[60]), 0.5 * std::abs(before));
}

TEST(LocalMethod, EndsAtOnceWhenNothingMayMoveFar) {
	const PatchAssembly assembly = assembled(jitteredGrid(9, 9, saddle));
	Positions positions = assembly.originalPositions;
	LocalMethodOptions options;
	options.maxDisplacement = 0;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(report.reason, Reason::NothingMoves);
	const auto undevelopable =
		(angleDefects(assembly, positions).array().abs() > options.angleTolerance).count();
	EXPECT_GT(undevelopable, 20);
	EXPECT_EQ(report.setAside, undevelopable);
	EXPECT_EQ(report.iterations, undevelopable);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(LocalMethod, SaysWhenItHasFoundNothingBetterForLong) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions options;
	options.angleTolerance = 1e-9;
	Positions positions = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, positions, options);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(report.reason, Reason::NotLowered);
	EXPECT_GT(report.iterations, 20 * 81);
	EXPECT_LT(report.iterations, options.maxOperations);
}

TEST(LocalMethod, GivesTheSameResultOnEveryRunAndForAnyScale) {
	const TriangleMesh mesh = jitteredGrid(12, 12, bumpedCylinder);
	const PatchAssembly assembly = assembled(mesh);
	LocalMethodOptions options;
	options.maxOperations = 300; // rounding grows with the number of operations
	Positions first = assembly.originalPositions, second = first;
	localMethod(assembly, first, options);
	localMethod(assembly, second, options);
	EXPECT_EQ(first, second);
	TriangleMesh larger = mesh;
	larger.positions *= 1024; // a power of two: scaling is exact
	const PatchAssembly assemblyOfLarger = assembled(larger);
	Positions third = assemblyOfLarger.originalPositions;
	localMethod(assemblyOfLarger, third, options);
	EXPECT_LT((third / 1024 - first).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LocalMethod, LeavesThePositionsAsTheyWereWhenStopped) {
	const PatchAssembly assembly = assembled(jitteredGrid(10, 10, saddle));
	Positions positions = assembly.originalPositions;
	const auto stop = [](double, const std::string&) { return false; };
	EXPECT_EQ(localMethod(assembly, positions, {}, stop).status, Status::Stopped);
	EXPECT_EQ(positions, assembly.originalPositions);
}

TEST(LocalMethod, RefusesWhatItCannotWorkOn) {
	const PatchAssembly closed = assembled(octahedron());
	Positions positions = closed.originalPositions;
	EXPECT_THROW(localMethod(closed, positions, {}), ClosedPatch);
	const PatchAssembly open = assembled(jitteredGrid(5, 5, saddle));
	positions = open.originalPositions;
	LocalMethodOptions options;
	options.maxDisplacement = -0.5;
	EXPECT_THROW(localMethod(open, positions, options), InvalidParameter);
	PatchOptions allHeld;
	allHeld.fixSelected = true;
	TriangleMesh mesh = jitteredGrid(5, 5, saddle);
	mesh.vertexSelected.assign(25, 1);
	const PatchAssembly held = assembled(mesh, allHeld);
	EXPECT_THROW(localMethod(held, positions, {}), NothingFree);
}

/// Two sheets sewn along an edge, with a ridge across the seam.
PatchAssembly sewnSheets() {
	const auto ridge = [](double u, double v) -> Eigen::Vector3d {
		return {u, v, 0.1 * std::exp(-20 * ((u - 1) * (u - 1) + (v - 0.5) * (v - 0.5)))};
	};
	return assembled(together(jitteredGrid(9, 9, ridge),
							  jitteredGrid(9, 9, [&](double u, double v) { return ridge(1 + u, v); })));
}

void expectEqualToSlow(const PatchAssembly& assembly, double displacement, double tolerance) {
	Positions expected = assembly.originalPositions, positions = expected;
	const long operations = slowLocalMethod(assembly, expected, tolerance, displacement, 3000);
	LocalMethodOptions options;
	options.maxDisplacement = displacement;
	options.angleTolerance = tolerance;
	options.maxOperations = 3000;
	EXPECT_EQ(localMethod(assembly, positions, options).iterations, operations);
	EXPECT_EQ(positions, expected);
	EXPECT_NE(positions, assembly.originalPositions);
}

TEST(LocalMethod, EqualsTheSlowOneToTheLastBit) {
	int case_ = 0;
	for (const Surface& surface : {Surface(bumpedCylinder), Surface(saddle), sphereCap(1.0)})
		for (const double displacement : {0.002, 0.05})
			for (const double tolerance : {0.01, 1e-4})
				expectEqualToSlow(assembled(jitteredGrid(8 + case_++ % 3, 9, surface)), displacement,
								  tolerance);
}

TEST(LocalMethod, EqualsTheSlowOneBetweenSeamsAndWhereVerticesAreEquallyBad) {
	expectEqualToSlow(sewnSheets(), 0.05, 1e-4);
	TriangleMesh mesh = grid(9, 9, flatSheet);
	for (const int vertex : {2 * 9 + 6, 4 * 9 + 4, 6 * 9 + 2}) // an order that no spatial one has
		mesh.positions(2, vertex) = 0.25;
	const PatchAssembly assembly = assembled(mesh);
	const Eigen::VectorXd defects = angleDefects(assembly, assembly.originalPositions);
	ASSERT_EQ(defects[2 * 9 + 6], defects[6 * 9 + 2]);
	for (const double displacement : {0.01, 0.2})
		expectEqualToSlow(assembly, displacement, 1e-4);
}

TEST(LocalMethod, DescentLowersTWithEveryMoveAndEndsByItself) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions descent;
	descent.descent = true;
	descent.angleTolerance = 1e-5; // out of reach
	Positions careful = assembly.originalPositions;
	const LocalMethodReport report = localMethod(assembly, careful, descent);
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_LT(report.iterations, descent.maxOperations / 2);
	EXPECT_GT(report.setAside, 0);
	EXPECT_LT(measured(assembly, careful).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
	// One move alone lowers G, for T holds all of G that it can change.
	descent.maxOperations = 1;
	Positions once = assembly.originalPositions;
	localMethod(assembly, once, descent);
	EXPECT_LT(measured(assembly, once).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
}

/// Σ over edges of the squared difference of the displacements of its ends.
double unevenness(const PatchAssembly& assembly, const Positions& positions) {
	const Positions moves = positions - assembly.originalPositions;
	double sum = 0;
	for (const auto& edge : assembly.edgePlaces.colwise())
		sum += (moves.col(edge[0]) - moves.col(edge[1])).squaredNorm();
	return sum / moves.squaredNorm();
}

/// Runs until G is as low as a bound, and no longer.
Positions runUntil(const PatchAssembly& assembly, LocalMethodOptions options, double bound) {
	long tooFew = 0, enough = options.maxOperations;
	Positions result;
	while (enough - tooFew > 1) {
		options.maxOperations = (tooFew + enough) / 2;
		Positions positions = assembly.originalPositions;
		localMethod(assembly, positions, options);
		if (measured(assembly, positions).detectFunction > bound) {
			tooFew = options.maxOperations;
		} else {
			enough = options.maxOperations;
			result = positions;
		}
	}
	return result;
}

TEST(LocalMethod, SmoothingEvensOutTheDisplacementsAtEqualDetectFunction) {
	const PatchAssembly assembly = hardCase();
	LocalMethodOptions options;
	options.descent = true;
	options.maxOperations = 20000;
	const double bound = 0.6 * measured(assembly, assembly.originalPositions).detectFunction;
	const Positions plain = runUntil(assembly, options, bound);
	options.smoothing = 0.01;
	const Positions smooth = runUntil(assembly, options, bound);
	ASSERT_GT(plain.size(), 0);
	ASSERT_GT(smooth.size(), 0);
	EXPECT_LT(unevenness(assembly, smooth), 0.9 * unevenness(assembly, plain));
	EXPECT_LT(roughness(assembly, smooth), roughness(assembly, plain));
}

TEST(LocalMethod, MovesSeamsWhenTheyMayMoveTogether) {
	const PatchAssembly assembly = sewnSheets();
	ASSERT_EQ(assembly.patchCount(), 2);
	ASSERT_EQ(assembly.assemblingPlaceCount(), 9);
	LocalMethodOptions options;
	options.descent = true;
	Positions fixed = assembly.originalPositions, together = fixed;
	localMethod(assembly, fixed, options);
	options.assemblingVertices = AssemblingVertices::MoveTogether;
	localMethod(assembly, together, options);
	double seamMove = 0;
	for (int place = 0; place < assembly.placeCount(); ++place)
		if (assembly.placeAssembling[place]) {
			EXPECT_EQ(fixed.col(place), assembly.originalPositions.col(place));
			seamMove =
				std::max(seamMove, (together.col(place) - assembly.originalPositions.col(place)).norm());
		}
	EXPECT_GT(seamMove, 1e-3);
	EXPECT_LT(measured(assembly, together).detectFunction, 0.8 * measured(assembly, fixed).detectFunction);
}

detail::PlacedTriangle placed(const Eigen::Vector3i& places, const Positions& positions) {
	return {places, positions(Eigen::all, places)};
}

/// How many pairs of triangles cut each other.
int countIntersections(const PatchAssembly& assembly, const Positions& positions) {
	std::vector<detail::PlacedTriangle> triangles;
	for (const auto& places : assembly.trianglePlaces.colwise())
		triangles.push_back(placed(places, positions));
	int count = 0;
	for (std::size_t a = 0; a < triangles.size(); ++a)
		for (std::size_t b = 0; b < a; ++b)
			count += detail::intersect(triangles[a], triangles[b]);
	return count;
}

/// A crumpled sheet just above a flat one.
TriangleMesh crumpledAboveFlat(unsigned seed) {
	std::mt19937 random(seed);
	const auto crumpled = [&](double u, double v) -> Eigen::Vector3d {
		return {u, v, 0.005 + 0.05 * random() / std::mt19937::max()};
	};
	return together(grid(13, 13, crumpled), grid(12, 12, flatSheet));
}

TEST(LocalMethod, AvoidsSelfIntersectionsWhereThePapersMovesMakeThem) {
	const PatchAssembly assembly = assembled(crumpledAboveFlat(5));
	ASSERT_EQ(countIntersections(assembly, assembly.originalPositions), 0);
	LocalMethodOptions options;
	options.maxDisplacement = 0.2;
	Positions through = assembly.originalPositions, clear = through;
	localMethod(assembly, through, options);
	EXPECT_GT(countIntersections(assembly, through), 0);
	options.avoidSelfIntersections = true;
	const LocalMethodReport report = localMethod(assembly, clear, options);
	EXPECT_EQ(countIntersections(assembly, clear), 0);
	EXPECT_GT(report.refusedMoves, 0);
	EXPECT_LT(measured(assembly, clear).detectFunction,
			  measured(assembly, assembly.originalPositions).detectFunction);
}

TEST(LocalMethod, AvoidsSelfIntersectionsThatRoundingWouldMake) {
	LocalMethodOptions options;
	options.maxDisplacement = 0.2;
	options.avoidSelfIntersections = true;
	int unaware = 0, aware = 0;
	for (unsigned seed = 1; seed <= 8; ++seed) {
		TriangleMesh mesh = crumpledAboveFlat(seed);
		mesh.positions = rounded<float>((mesh.positions.array() + 1000).matrix()); // rounding counts far out
		const PatchAssembly assembly = assembled(mesh);
		ASSERT_EQ(countIntersections(assembly, assembly.originalPositions), 0);
		for (const bool roundedToFloat : {false, true}) {
			options.roundedToFloat = roundedToFloat;
			Positions positions = assembly.originalPositions;
			localMethod(assembly, positions, options);
			(roundedToFloat ? aware : unaware) += countIntersections(assembly, rounded<float>(positions));
		}
	}
	EXPECT_GT(unaware, 0);
	EXPECT_EQ(aware, 0);
}

TEST(BoxTree, FindsAllThatMeetABoxWhileTheyMove) {
	std::mt19937 random(2);
	const auto randomBox = [&](double size) {
		const auto share = [&] { return double(random()) / std::mt19937::max(); };
		const Eigen::Vector3d at(share(), share(), share());
		Eigen::Matrix3d points;
		for (auto point : points.colwise())
			point = at + size * Eigen::Vector3d(share(), share(), share());
		return detail::boxOf(points);
	};
	for (const int count : {1, 8, 9, 700}) {
		std::vector<detail::Box> boxes(count);
		for (detail::Box& box : boxes)
			box = randomBox(0.1);
		detail::BoxTree tree(boxes);
		for (int round = 0; round < 200; ++round) {
			const int mover = static_cast<int>(random() % count);
			boxes[mover] = randomBox(0.1);
			tree.extend(mover, boxes[mover]);
			const detail::Box wanted = randomBox(0.3);
			const std::vector<int>& found = tree.near(wanted);
			for (int i = 0; i < count; ++i) {
				const bool meets = (boxes[i].head<3>() <= -wanted.tail<3>()).all() &&
								   (wanted.head<3>() <= -boxes[i].tail<3>()).all();
				EXPECT_EQ(detail::contains(boxes[i], detail::core(wanted)), meets);
				if (meets) {
					EXPECT_EQ(std::count(found.begin(), found.end(), i), 1);
				}
			}
			if (count == 700 && round == 0) {
				EXPECT_LT(found.size(), 100);
			}
		}
	}
}

TEST(TriangleIntersection, KnowsDisjointCrossingAndJoinedTriangles) {
	Positions positions(3, 7);
	positions << 0, 1, 0, 0.2, 0.2, 0.2, 0.5, /**/ 0, 0, 1, 0.2, 0.2, 0.9, 0.5, /**/ 0, 0, 0, -1, 1, 1, -0.5;
	const auto triangle = [&](int a, int b, int c) { return placed({a, b, c}, positions); };
	EXPECT_TRUE(detail::intersect(triangle(0, 1, 2), triangle(3, 4, 5)));  // pierced by an edge
	EXPECT_FALSE(detail::intersect(triangle(0, 1, 2), triangle(0, 1, 4))); // joined along an edge
	EXPECT_FALSE(detail::intersect(triangle(0, 1, 2), triangle(0, 4, 5))); // joined at a vertex, above
	EXPECT_TRUE(detail::intersect(triangle(0, 1, 2), triangle(0, 4, 3)));  // joined at a vertex, through
	EXPECT_FALSE(detail::intersect(triangle(0, 1, 2), triangle(1, 4, 5))); // the same on the other side
}

TEST(Tournament, HandsOutTheLargestKeyFirstWhateverItsHistory) {
	for (const int count : {1, 7, 33, 200}) {
		std::mt19937 random(3);
		std::vector<int> ranks(count);
		std::iota(ranks.begin(), ranks.end(), 0);
		std::shuffle(ranks.begin(), ranks.end(), random);
		detail::Tournament tournament(ranks);
		std::vector<double> keys(count, -1); // by rank
		for (int round = 0; round < 5000; ++round) {
			const int item = static_cast<int>(random() % count);
			double& key = keys[ranks[item]];
			EXPECT_EQ(tournament.contains(item), key >= 0);
			key = random() % 4 == 0 ? -1 : static_cast<double>(random() % 50);
			if (key < 0)
				tournament.remove(item);
			else
				tournament.set(item, key);
			const auto largest = std::max_element(keys.begin(), keys.end()); // the first of equals
			ASSERT_EQ(tournament.size(),
					  std::count_if(keys.begin(), keys.end(), [](double k) { return k >= 0; }));
			ASSERT_EQ(tournament.empty(), *largest < 0);
			if (!tournament.empty()) {
				ASSERT_EQ(ranks[tournament.top()], largest - keys.begin());
				ASSERT_EQ(tournament.topKey(), *largest);
			}
		}
	}
}

TEST(Tournament, TakesOutWhatIsNotANumber) {
	const std::vector<int> ranks = {0, 1, 2};
	detail::Tournament tournament(ranks);
	tournament.set(0, 1);
	tournament.set(1, std::nan(""));
	EXPECT_EQ(tournament.size(), 1);
	EXPECT_EQ(tournament.top(), 0);
}

TEST(SpatialOrder, NumbersEachPointOnceAndNeighboursClosely) {
	const int side = 64;
	const TriangleMesh mesh = grid(side, side, flatSheet);
	const std::vector<int> order = detail::spatialOrder(mesh.positions);
	std::vector<int> number(order.size(), -1);
	for (int i = 0; i < side * side; ++i)
		number[order[i]] = i;
	EXPECT_EQ(std::count(number.begin(), number.end(), -1), 0);
	int near = 0;
	for (int v = side; v < side * side; ++v)
		near += std::abs(number[v] - number[v - side]) < side / 2; // row by row all of them are `side` apart
	EXPECT_GT(near, 0.7 * side * side);
}

} // namespace
} // namespace developable::test
