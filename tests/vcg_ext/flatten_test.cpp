// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/flatten.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace developable::test {
namespace {

FlatPatterns flattened(const TriangleMesh& mesh, const FlattenOptions& options = {}) {
	const PatchAssembly assembly = assembled(mesh);
	return flattenPatches(assembly, assembly.originalPositions, options);
}

/// A surface that is closed in u: columns vertices round, rows along.
TriangleMesh ring(int columns, int rows, const Surface& surface) {
	const TriangleMesh open = grid(columns + 1, rows, surface);
	Positions positions(3, columns * rows);
	const auto vertex = [&](int v) { return v / (columns + 1) * columns + v % (columns + 1) % columns; };
	for (int v = 0; v < open.vertexCount(); ++v)
		if (v % (columns + 1) < columns)
			positions.col(vertex(v)) = open.positions.col(v);
	return makeMesh(positions, open.triangles.unaryExpr(vertex));
}

Eigen::Vector3d tube(double u, double v) {
	return {std::cos(2 * pi * u), std::sin(2 * pi * u), 3 * v};
}

/// A ring cut from a cone whose half angle has this sine.
Surface frustum(double sine) {
	return [sine](double u, double v) -> Eigen::Vector3d {
		const double radius = 0.5 + 0.5 * v;
		return {radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u),
				0.5 * v * std::sqrt(1 / (sine * sine) - 1)};
	};
}

Surface bump(double height, double steepness) {
	return [=](double u, double v) -> Eigen::Vector3d {
		const double distance = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
		return {u, v, height * std::exp(-steepness * distance)};
	};
}

/// Without the triangles whose vertices all satisfy a condition.
template <class Condition>
TriangleMesh without(const TriangleMesh& mesh, const Condition& condition) {
	std::vector<int> kept;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const auto triangle = mesh.triangles.col(t);
		if (!std::all_of(triangle.begin(), triangle.end(),
						 [&](int v) { return condition(Eigen::Vector3d(mesh.positions.col(v))); }))
			kept.push_back(t);
	}
	return makeMesh(mesh.positions, mesh.triangles(Eigen::all, kept));
}

TriangleMesh withHole(const TriangleMesh& mesh, const Eigen::Vector2d& centre, double radius) {
	return without(mesh, [&](const Eigen::Vector3d& p) { return (p.head<2>() - centre).norm() < radius; });
}

TriangleMesh noisySheet(double noise) {
	TriangleMesh mesh = jitteredGrid(25, 25, flatSheet);
	std::mt19937 random(3);
	for (auto& z : mesh.positions.row(2))
		z = noise * (2.0 * random() / std::mt19937::max() - 1);
	return mesh;
}

detail::PanelMesh onlyPanel(const PatchAssembly& assembly) {
	std::vector<int> panelTriangle(assembly.triangleCount());
	return detail::makePanel(assembly, assembly.originalPositions, detail::trianglesOfPatches(assembly)[0],
							 detail::triangleTurned(assembly, assembly.originalPositions), panelTriangle);
}

/// The layout of an uncut panel, in the order of the panel's vertices.
detail::PlanePositions inPanelOrder(const FlatPatterns& patterns, const detail::PanelMesh& panel) {
	detail::PlanePositions positions(2, panel.vertexCount());
	for (int corner = 0; corner < panel.halfEdgeCount(); ++corner)
		positions.col(panel.start(corner)) = patterns.positions.col(patterns.vertexAt(corner));
	return positions;
}

/// Both triangles of a matrix of which one is stored.
Eigen::MatrixXd dense(const detail::PlaneHessian& hessian) {
	const Eigen::MatrixXd lower(hessian.matrix());
	return lower.selfadjointView<Eigen::Lower>();
}

int edgeCount(const FlatPatterns& patterns) {
	int count = 0;
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h)
		count += patterns.joinedHalfEdge[h] < h;
	return count;
}

double doubleArea(const FlatPatterns& patterns, int triangle) {
	return detail::doubleArea(patterns.positions, patterns.triangles.col(triangle));
}

TEST(Flatten, DevelopablePanelsComeOutIsometric) {
	for (const TriangleMesh& mesh :
		 {jitteredGrid(15, 12, flatSheet), grid(20, 15, quarterCylinder), grid(15, 20, coneBand)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
		EXPECT_EQ(patterns.report.flippedFaces, 0);
		EXPECT_EQ(patterns.triangles, mesh.triangles); // a disk keeps its vertices' order
		EXPECT_TRUE(patterns.report.notes.empty());
	}
}

TEST(Flatten, AQuarterCylinderBecomesARectangle) {
	const int columns = 30;
	const FlatPatterns patterns = flattened(grid(columns, 10, quarterCylinder));
	const Eigen::Vector2d size =
		patterns.positions.rowwise().maxCoeff() - patterns.positions.rowwise().minCoeff();
	const double arc = 2 * (columns - 1) * std::sin(pi / 4 / (columns - 1)); // of chords
	// Its longest side stands upright.
	EXPECT_NEAR(size[1], arc, 1e-12);
	EXPECT_NEAR(size[0], 1, 1e-12);
}

TEST(Flatten, ATubeIsCutOnceAndBothSidesOfTheCutAreASeam) {
	const TriangleMesh mesh = ring(24, 9, tube);
	const FlatPatterns patterns = flattened(mesh);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
	EXPECT_EQ(patterns.pieces[0].holes, 1);
	EXPECT_EQ(patterns.pieces[0].cuts, 1);
	EXPECT_EQ(patterns.vertexCount(), mesh.vertexCount() + 9);
	ASSERT_EQ(patterns.seams.size(), 1u);
	EXPECT_EQ(patterns.seams[0].halfEdges[0].size(), 8u);
	EXPECT_NEAR(patterns.seams[0].length[0], 3, 1e-11); // straight along the tube: the shortest way
	EXPECT_LT(patterns.seams[0].mismatch(), 1e-11);
	EXPECT_EQ(patterns.report.notes.size(), 1u);
}

TEST(Flatten, AConeIsCutEvenWhereItIsNearlyFlat) {
	for (const double sine : {0.1, 0.5, 0.9, 0.99}) {
		const FlatPatterns patterns = flattened(ring(40, 12, frustum(sine)));
		EXPECT_EQ(patterns.pieces[0].cuts, 1) << sine;
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-10) << sine;
	}
}

TEST(Flatten, AWindowStaysOpenAndUncut) {
	const TriangleMesh flat = withHole(jitteredGrid(30, 30, flatSheet), {0.4, 0.55}, 0.2);
	TriangleMesh bent = flat; // rolled up
	for (auto p : bent.positions.colwise())
		p = Eigen::Vector3d(std::sin(p[0]), p[1], std::cos(p[0]));
	for (const TriangleMesh& mesh : {flat, withHole(flat, {0.8, 0.2}, 0.12)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_EQ(patterns.pieces[0].cuts, 0);
		EXPECT_GT(patterns.pieces[0].holes, 0);
		EXPECT_EQ(patterns.triangles.cols(), mesh.triangleCount()); // nothing filled
		EXPECT_LT(patterns.report.maxEdgeStrain, 1e-11);
		EXPECT_TRUE(patterns.report.notes.empty());
	}
	// Rolled on a jittered grid it is only nearly developable.
	const FlatPatterns patterns = flattened(bent);
	EXPECT_EQ(patterns.pieces[0].cuts, 0);
	EXPECT_LT(patterns.report.meanEdgeStrain, 2e-4);
	EXPECT_EQ(patterns.report.flippedFaces, 0);
}

TEST(Flatten, PanelsWithSeveralHolesAreCutFromHoleToHole) {
	// A tube with a window: the tube's end needs a cut, the window none.
	const TriangleMesh mesh = without(
		ring(40, 30, tube), [](const Eigen::Vector3d& p) { return p[0] > 0.8 && p[2] > 1 && p[2] < 2; });
	const FlatPatterns patterns = flattened(mesh);
	EXPECT_EQ(patterns.pieces[0].holes, 2);
	EXPECT_EQ(patterns.pieces[0].cuts, 1);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-10);
}

TEST(Flatten, LowersTheEnergyOfTheConformalStart) {
	for (const Surface& surface : {sphereCap(1), Surface(saddle), Surface(bumpedCylinder)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(20, 20, surface));
		const detail::PanelMesh panel = onlyPanel(assembly);
		const detail::PlaneSprings springs(panel);
		const detail::PlanePositions start = detail::conformalStart(panel);
		const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
		EXPECT_LT(patterns.report.elasticEnergy, 0.5 * springs.energy(start));
		EXPECT_TRUE(patterns.pieces[0].converged);
	}
}

TEST(Flatten, IsNextToTheLeastEnergyAndHasLessMeanStrain) {
	for (const Surface& surface : {sphereCap(1), Surface(saddle), Surface(bumpedCylinder)}) {
		const PatchAssembly assembly = assembled(jitteredGrid(20, 20, surface));
		const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
		detail::FlatPanel least{onlyPanel(assembly), detail::conformalStart(onlyPanel(assembly)), {}, 0};
		detail::PlaneSprings springs(least.mesh);
		const double first = springs.energy(least.positions);
		EXPECT_TRUE(detail::FlipFreeNewton(springs, least.positions).minimize(400, {}).converged);
		// At a minimum no vertex is pulled anywhere.
		EXPECT_LT(springs.gradient(least.positions).norm(), 1e-5 * std::sqrt(first));
		EXPECT_GT(patterns.report.elasticEnergy, springs.energy(least.positions));
		EXPECT_LT(patterns.report.elasticEnergy, 1.005 * springs.energy(least.positions));
		EXPECT_LT(patterns.report.meanEdgeStrain, 0.985 * detail::edgeStrains(least).mean());
	}
}

TEST(Flatten, StrainOfASphereCapIsThatOfItsCurvature) {
	// The strain of a flattened cap grows with its curvature times its area.
	const double strain = flattened(jitteredGrid(20, 20, sphereCap(1))).report.meanEdgeStrain;
	const double whole =
		1.05 / (8 * pi); // ∫K dA / 8π: the strain at the rim of a round cap of that curvature
	EXPECT_LT(strain, whole);
	EXPECT_GT(strain, whole / 10);
}

TEST(Flatten, FlipsNothingHoweverHardThePanel) {
	for (const TriangleMesh& mesh : {jitteredGrid(25, 25, bump(1, 30)), noisySheet(0.02), noisySheet(0.1)}) {
		const FlatPatterns patterns = flattened(mesh);
		EXPECT_EQ(patterns.report.flippedFaces, 0);
		for (int t = 0; t < mesh.triangleCount(); ++t)
			EXPECT_GT(doubleArea(patterns, t), 0);
	}
}

TEST(Flatten, TheCircleStartFlipsNothingAndLeadsToTheSameMinimum) {
	const PatchAssembly assembly = assembled(withHole(jitteredGrid(20, 20, bumpedCylinder), {0, 0.5}, 0.1));
	const detail::PanelMesh panel = onlyPanel(assembly);
	detail::PlanePositions x = detail::circleStart(panel, detail::boundaryLoops(panel));
	EXPECT_EQ(detail::countFlipped(panel.triangles, x), 0);
	detail::PlaneSprings springs(panel);
	EXPECT_TRUE(detail::FlipFreeNewton(springs, x).minimize(400, {}).converged);
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions);
	EXPECT_EQ(patterns.pieces[0].holes, 1);
	detail::PlanePositions other = inPanelOrder(patterns, panel);
	EXPECT_TRUE(detail::FlipFreeNewton(springs, other).minimize(400, {}).converged);
	EXPECT_NEAR(springs.energy(x), springs.energy(other), 1e-8 * springs.energy(x));
}

class Springs : public testing::TestWithParam<double> {};

/// With the barrier off and with it acting on most triangles.
TEST_P(Springs, DerivativesAgreeWithCentralDifferences) {
	const PatchAssembly assembly = assembled(jitteredGrid(5, 6, bump(0.5, 10)));
	const detail::PanelMesh panel = onlyPanel(assembly);
	detail::PlaneSprings springs(panel);
	springs.setGuardedShare(GetParam());
	const detail::PlanePositions x = panel.positions.topRows(2);
	const int size = static_cast<int>(x.size());
	const double step = 1e-6;
	const detail::PlanePositions gradient = springs.gradient(x);
	detail::PlaneHessian hessian = springs.hessianPattern(), convex = hessian;
	springs.addHessian(x, false, hessian);
	springs.addHessian(x, true, convex);
	const Eigen::MatrixXd full = dense(hessian);
	for (int i = 0; i < size; ++i) {
		detail::PlanePositions above = x, below = x;
		above.data()[i] += step;
		below.data()[i] -= step;
		const double slope = (springs.guardedEnergy(above) - springs.guardedEnergy(below)) / (2 * step);
		EXPECT_NEAR(gradient.data()[i], slope, 1e-7);
		const Eigen::VectorXd column =
			((springs.gradient(above) - springs.gradient(below)) / (2 * step)).reshaped();
		EXPECT_LT((full.col(i) - column).norm(), 1e-6 * full.col(i).norm());
	}
	const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense(convex)), eigenFull(full);
	EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-12);
	EXPECT_LT(eigenFull.eigenvalues().minCoeff(), -1e-3); // there was something to leave out
}

INSTANTIATE_TEST_SUITE_P(Barrier, Springs, testing::Values(0.1, 1.0, 3.0));

TEST(Flatten, TheLongestStepIsWhereTheFirstTriangleLosesItsArea) {
	const PatchAssembly assembly = assembled(grid(4, 4, flatSheet));
	const detail::PanelMesh panel = onlyPanel(assembly);
	const detail::PlaneSprings springs(panel);
	const detail::PlanePositions x = panel.positions.topRows(2);
	std::mt19937 random(5);
	for (int round = 0; round < 20; ++round) {
		const detail::PlanePositions direction =
			x.unaryExpr([&](double) { return 2.0 * random() / std::mt19937::max() - 1; });
		const double longest = springs.longestStep(x, direction);
		ASSERT_TRUE(std::isfinite(longest));
		EXPECT_EQ(detail::countFlipped(panel.triangles, x + 0.9999 * longest * direction), 0);
		EXPECT_GT(detail::countFlipped(panel.triangles, x + 1.0001 * longest * direction), 0);
	}
	EXPECT_EQ(springs.longestStep(x, x), std::numeric_limits<double>::infinity()); // growing flips nothing
}

TEST(Flatten, DoesNotDependOnWhereTheModelIsAndHowLargeItIs) {
	TriangleMesh mesh = jitteredGrid(18, 14, bumpedCylinder);
	const FlatPatterns before = flattened(mesh);
	const Positions positions = mesh.positions;
	for (const double scale : {1e-3, 1.0, 1e4}) {
		mesh.positions = moved(positions, scale, scale * Eigen::Vector3d(3, -2, 1));
		const FlatPatterns after = flattened(mesh);
		EXPECT_NEAR(after.report.maxEdgeStrain, before.report.maxEdgeStrain, 1e-8);
		EXPECT_NEAR(after.report.elasticEnergy / (scale * scale), before.report.elasticEnergy,
					1e-8 * before.report.elasticEnergy);
		EXPECT_LT((after.edgeStrain - before.edgeStrain).norm(), 1e-6);
	}
}

TEST(Flatten, IsTheSameEveryTime) {
	const TriangleMesh mesh = jitteredGrid(18, 14, bumpedCylinder);
	EXPECT_EQ(flattened(mesh).positions, flattened(mesh).positions);
}

TEST(Flatten, TheOutsideShowsWhicheverWayTheFacesAreTurned) {
	TriangleMesh mesh = grid(12, 9, quarterCylinder);
	TriangleMesh inside = mesh;
	inside.triangles.row(1).swap(inside.triangles.row(2));
	for (int t = 0; t < mesh.triangleCount(); t += 3)
		mesh.triangles.col(t).reverseInPlace();
	const FlatPatterns front = flattened(grid(12, 9, quarterCylinder)), back = flattened(inside),
					   mixed = flattened(mesh);
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		EXPECT_GT(doubleArea(front, t), 0);
		EXPECT_GT(doubleArea(back, t), 0);
		EXPECT_EQ(doubleArea(mixed, t) > 0, t % 3 != 0) << "corners keep their order";
	}
	EXPECT_EQ(mixed.report.flippedFaces, 0);
	EXPECT_LT(mixed.report.maxEdgeStrain, 1e-12);
}

TEST(Flatten, SeamsOfTwoPanelsHaveBothLengthsAndTheirMismatch) {
	const TriangleMesh left = grid(8, 11, quarterCylinder);
	TriangleMesh right = left; // turned about the shared edge at u = 0, x = 1
	right.positions.row(1) *= -1;
	right.triangles.row(1).swap(right.triangles.row(2));
	const FlatPatterns patterns = flattened(together(left, right));
	ASSERT_EQ(patterns.seams.size(), 1u);
	const Seam& seam = patterns.seams[0];
	EXPECT_EQ(seam.piece[0] + seam.piece[1], 1);
	EXPECT_NEAR(seam.length[0], 1, 1e-12);
	EXPECT_NEAR(seam.length[1], 1, 1e-12);
	EXPECT_LT(patterns.report.maxSeamMismatch, 1e-12);
	for (std::size_t i = 0; i < seam.halfEdges[0].size(); ++i) {
		std::array<std::array<int, 2>, 2> places;
		for (const int side : {0, 1}) {
			const int h = seam.halfEdges[side][i];
			places[side] = {patterns.placeOfVertex[patterns.vertexAt(h)],
							patterns.placeOfVertex[patterns.vertexAt(detail::nextCorner(h))]};
			std::sort(places[side].begin(), places[side].end());
		}
		EXPECT_EQ(places[0], places[1]);
	}
}

TEST(Flatten, OfThreePanelsAtAnEdgeTwoAreSewnToTheFirstWhateverTheOrderOfTriangles) {
	const auto page = [](double angle) {
		return grid(4, 9, [angle](double u, double v) -> Eigen::Vector3d {
			return {u * std::cos(angle), u * std::sin(angle), v};
		});
	};
	TriangleMesh mesh = together(together(page(0), page(2)), page(4));
	const int third = mesh.triangleCount() / 3;
	const Eigen::Matrix3Xi triangles = mesh.triangles;
	for (int t = 0; t < mesh.triangleCount(); ++t) // the panels take turns, one of them from its end
		mesh.triangles.col(t) = triangles.col(t % 3 * third + (t % 3 != 1 ? t / 3 : third - 1 - t / 3));
	const FlatPatterns patterns = flattened(mesh);
	ASSERT_EQ(patterns.seams.size(), 2u);
	for (const int seam : {0, 1}) {
		EXPECT_EQ(patterns.seams[seam].halfEdges[0].size(), 8u);
		EXPECT_EQ(std::min(patterns.seams[seam].piece[0], patterns.seams[seam].piece[1]), 0);
		EXPECT_EQ(std::max(patterns.seams[seam].piece[0], patterns.seams[seam].piece[1]), seam + 1);
	}
}

TEST(Flatten, SeamsBetweenAStrainedAndAFlatPanelDoNotMatch) {
	// A bumped sheet beside a flat one that shares its edge x = 1.
	TriangleMesh left = jitteredGrid(15, 15, bump(0.3, 10)), right = left;
	for (auto p : right.positions.colwise())
		p[0] = 2 - p[0];
	for (int v = 0; v < right.vertexCount(); ++v)
		if (v % 15 != 14)
			right.positions(2, v) = right.positions(2, v - v % 15 + 14);
	const FlatPatterns patterns = flattened(together(left, right));
	ASSERT_EQ(patterns.seams.size(), 1u);
	EXPECT_GT(patterns.report.maxSeamMismatch, 1e-4);
	EXPECT_DOUBLE_EQ(patterns.report.maxSeamMismatch, patterns.seams[0].mismatch());
}

TEST(Flatten, PiecesLieApartByTheGap) {
	TriangleMesh mesh = grid(6, 6, quarterCylinder);
	for (int copy = 1; copy < 7; ++copy) {
		TriangleMesh other = grid(5, 4 + copy, coneBand);
		other.positions.row(2).array() += 5 * copy;
		mesh = together(mesh, other);
	}
	for (const double gap : {0.0, 0.5, -1.0}) {
		const FlatPatterns patterns = flattened(mesh, {gap, 400});
		std::vector<Eigen::AlignedBox2d> boxes(7);
		double largest = 0;
		for (int v = 0; v < patterns.vertexCount(); ++v)
			boxes[patterns.pieceOfVertex[v]].extend(patterns.positions.col(v));
		for (const auto& box : boxes)
			largest = std::max(largest, box.diagonal().norm());
		const double expected = gap < 0 ? 0.02 * largest : gap;
		double nearest = std::numeric_limits<double>::infinity();
		for (int a = 0; a < 7; ++a)
			for (int b = 0; b < a; ++b)
				nearest = std::min(nearest, boxes[a].exteriorDistance(boxes[b]));
		EXPECT_NEAR(nearest, expected, 1e-12);
		EXPECT_EQ(patterns.report.overlappingPieces, 0);
		EXPECT_EQ(patterns.report.pieces, 7);
	}
}

TEST(Flatten, APieceThatOverlapsItselfIsReported) {
	// A flat ribbon wound up as a helix: its pattern is a ring that goes round one and a half times.
	const auto helix = [](double u, double v) -> Eigen::Vector3d {
		const double angle = 3 * pi * u, radius = 1 + 0.3 * v;
		return {radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle};
	};
	const FlatPatterns patterns = flattened(grid(90, 4, helix));
	EXPECT_EQ(patterns.report.overlappingPieces, 1);
	EXPECT_EQ(patterns.report.flippedFaces, 0);
	EXPECT_LT(patterns.report.maxEdgeStrain, 1e-2);
	EXPECT_EQ(patterns.report.notes.size(), 1u);
}

TEST(Flatten, MapsAddUpToTheReport) {
	const FlatPatterns patterns = flattened(together(jitteredGrid(12, 12, sphereCap(1)), ring(12, 8, tube)));
	EXPECT_EQ(patterns.edgeStrain.maxCoeff(), patterns.report.maxEdgeStrain);
	EXPECT_NEAR(patterns.elasticEnergy.sum(), patterns.report.elasticEnergy,
				1e-12 * patterns.report.elasticEnergy);
	double mean = 0;
	for (int h = 0; h < static_cast<int>(patterns.joinedHalfEdge.size()); ++h) {
		if (patterns.joinedHalfEdge[h] >= h)
			continue;
		EXPECT_LE(patterns.joinedHalfEdge[h], h);
	}
	EXPECT_EQ(edgeCount(patterns), 12 * 11 * 2 + 11 * 11 + 12 * 8 + 12 * 7 * 2 + 7);
	for (const FlatPiece& piece : patterns.pieces)
		mean = std::max(mean, piece.meanEdgeStrain);
	EXPECT_GT(mean, patterns.report.meanEdgeStrain);
	const PatchAssembly assembly = assembled(together(jitteredGrid(12, 12, sphereCap(1)), ring(12, 8, tube)));
	EXPECT_EQ(largestAtPlaces(assembly, patterns, patterns.edgeStrain).maxCoeff(),
			  patterns.report.maxEdgeStrain);
}

TEST(Flatten, RefusesWhatCannotBeFlatAndSaysHowMany) {
	try {
		flattened(together(octahedron(), grid(3, 3, flatSheet)));
		FAIL();
	} catch (const ClosedPatch& error) {
		EXPECT_NE(std::string(error.what()).find("1 of 2 patches"), std::string::npos) << error.what();
	}
	// A torus with a triangle missing has a boundary and a handle.
	TriangleMesh torus = ring(12, 9, [](double u, double v) -> Eigen::Vector3d {
		const double radius = 2 + std::cos(2 * pi * v);
		return {radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), std::sin(2 * pi * v)};
	});
	torus.triangles = torus.triangles.unaryExpr([](int v) { return v >= 96 ? v - 96 : v; }).eval();
	torus.triangles.conservativeResize(3, torus.triangles.cols() - 1);
	torus = makeMesh(torus.positions, torus.triangles);
	try {
		flattened(torus);
		FAIL();
	} catch (const PatchWithHandles& error) {
		EXPECT_NE(std::string(error.what()).find("1 patch has a handle"), std::string::npos) << error.what();
	}
	// A Möbius strip.
	TriangleMesh strip = grid(21, 3, [](double u, double v) -> Eigen::Vector3d {
		const double angle = 2 * pi * u, radius = 3 + (v - 0.5) * std::cos(angle / 2);
		return {radius * std::cos(angle), radius * std::sin(angle), (v - 0.5) * std::sin(angle / 2)};
	});
	const auto sewn = [](int v) { return v % 21 == 20 ? (2 - v / 21) * 21 : v; };
	EXPECT_THROW(flattened(makeMesh(strip.positions, strip.triangles.unaryExpr(sewn))), NonOrientablePatch);
	EXPECT_THROW(flattened(grid(3, 3, flatSheet), {std::nan(""), 400}), InvalidParameter);
}

TEST(Flatten, StopsWhenAsked) {
	const PatchAssembly assembly = assembled(jitteredGrid(15, 15, sphereCap(1)));
	double furthest = 0;
	const FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions, {},
												 [&](double fraction, const std::string& message) {
													 EXPECT_FALSE(message.empty());
													 EXPECT_GE(fraction, furthest);
													 EXPECT_LE(fraction, 1);
													 furthest = fraction;
													 return fraction < 0.002;
												 });
	EXPECT_TRUE(patterns.report.stopped);
	EXPECT_EQ(patterns.vertexCount(), 0);
}

} // namespace
} // namespace developable::test
