// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/newton/displacement_metric.h"
#include "support/newton_checks.h"

#include <thread>

namespace developable::test {
namespace {

/// Panels of several kinds that share nothing: two that converge, a pair that is sewn together, one that is
/// flat, and one that needs a cut.
std::vector<TriangleMesh> strangers() {
	TriangleMesh half = jitteredGrid(9, 9, saddle), other = half;
	other.positions.row(0) = 2 - other.positions.row(0).array();
	TriangleMesh ball = sphere(1, 3);
	std::vector<int> kept;
	for (int t = 0; t < ball.triangleCount(); ++t)
		if (ball.positions(2, ball.triangles(0, t)) < 0.9)
			kept.push_back(t);
	ball = makeMesh(ball.positions, ball.triangles(Eigen::all, kept));
	std::vector<TriangleMesh> meshes = {jitteredGrid(16, 16, wave), ball, grid(5, 5, flatSheet),
										together(half, other), jitteredGrid(12, 18, vamp)};
	for (std::size_t i = 0; i < meshes.size(); ++i)
		meshes[i].positions.row(2).array() += 8.0 * double(i);
	return meshes;
}

TriangleMesh inOrder(const std::vector<TriangleMesh>& meshes, const std::vector<int>& order) {
	TriangleMesh result = meshes[order[0]];
	for (std::size_t i = 1; i < order.size(); ++i)
		result = together(result, meshes[order[i]]);
	return result;
}

/// Of every vertex of one mesh after another, where the method takes them.
Positions developed(const TriangleMesh& mesh, int threads, ConstrainedNewtonReport& report) {
	const PatchAssembly assembly = assembled(mesh);
	ConstrainedNewtonOptions options;
	options.threads = threads;
	Positions places = assembly.originalPositions;
	report = constrainedNewton(assembly, places, options);
	Positions vertices = mesh.positions;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		if (assembly.placeOfVertex[vertex] >= 0)
			vertices.col(vertex) = places.col(assembly.placeOfVertex[vertex]);
	return vertices;
}

std::vector<Status> patchStatuses(const ConstrainedNewtonReport& report) {
	std::vector<Status> statuses;
	for (const PatchVerdict& verdict : report.patchVerdicts)
		statuses.push_back(verdict.status);
	return statuses;
}

TEST(ConstrainedNewtonParts, HaveTheSameBitsAloneAndInAnyCompanyOnAnyNumberOfThreads) {
	const std::vector<TriangleMesh> meshes = strangers();
	std::vector<Positions> alone;
	std::vector<Status> statuses;
	double work = 0;
	for (const TriangleMesh& mesh : meshes) {
		ConstrainedNewtonReport report;
		alone.push_back(developed(mesh, 1, report));
		statuses.push_back(report.status);
		work += report.work;
		EXPECT_EQ(report.work > 0, report.status != Status::NothingToDo);
	}
	EXPECT_EQ(statuses, (std::vector<Status>{Status::Converged, Status::NeedsCut, Status::NothingToDo,
											 Status::Converged, Status::Converged}));
	for (const std::vector<int>& order : {std::vector<int>{0, 1, 2, 3, 4}, {3, 1, 4, 0, 2}})
		for (const int threads : {1, 2, 3}) {
			ConstrainedNewtonReport report;
			const Positions vertices = developed(inOrder(meshes, order), threads, report);
			EXPECT_EQ(report.status, Status::NeedsCut);
			EXPECT_EQ(report.patchesNeedingCut, 1);
			EXPECT_DOUBLE_EQ(report.work, work);
			Eigen::Index first = 0;
			for (const int i : order) {
				EXPECT_EQ(vertices.middleCols(first, alone[i].cols()), alone[i]);
				first += alone[i].cols();
			}
			std::vector<Status> expected;
			for (const int i : order)
				expected.insert(expected.end(), i == 3 ? 2 : 1, statuses[i]);
			EXPECT_EQ(patchStatuses(report), expected);
		}
}

TEST(ConstrainedNewtonParts, StopTogetherAndTellTheCallerAlone) {
	const PatchAssembly assembly = assembled(inOrder(strangers(), {0, 1, 2, 3, 4}));
	const auto caller = std::this_thread::get_id();
	for (const int threads : {1, 2}) {
		ConstrainedNewtonOptions options;
		options.threads = threads;
		Positions positions = assembly.originalPositions;
		double last = 0;
		const auto stopLate = [&](double fraction, const std::string&) {
			EXPECT_EQ(std::this_thread::get_id(), caller);
			EXPECT_GE(fraction, last);
			last = fraction;
			return fraction < 0.1;
		};
		EXPECT_EQ(constrainedNewton(assembly, positions, options, stopLate).status, Status::Stopped);
		EXPECT_EQ(positions, assembly.originalPositions);
	}
}

TEST(ConstrainedNewtonParts, WithNothingFreeStayWhileOthersMove) {
	TriangleMesh held = jitteredGrid(8, 8, saddle), free = jitteredGrid(8, 8, saddle);
	free.positions.row(2).array() += 5;
	held.vertexSelected.assign(held.vertexCount(), 1);
	TriangleMesh mesh = together(held, free);
	mesh.vertexSelected.assign(mesh.vertexCount(), 0);
	std::fill_n(mesh.vertexSelected.begin(), held.vertexCount(), char(1));
	PatchOptions patchOptions;
	patchOptions.fixSelected = true;
	const PatchAssembly assembly = assembled(mesh, patchOptions);
	Positions positions = assembly.originalPositions;
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, {});
	EXPECT_EQ(patchStatuses(report), (std::vector<Status>{Status::Stalled, Status::Converged}));
	EXPECT_EQ(report.status, Status::Stalled);
	EXPECT_EQ(positions.leftCols(64), assembly.originalPositions.leftCols(64));
}

/// What a run without a bound does one with it can do as well.
TEST(ConstrainedNewtonParts, OfSewnPanelsKeepToABoundThatTheyKeepToByDefault) {
	for (const auto& [surface, height] : {std::make_pair(Surface(vamp), 1.0), {Surface(saddle), 2.0}}) {
		const PatchAssembly assembly = mirroredPatches(25, surface, height);
		ConstrainedNewtonOptions options;
		options.maxDisplacement = 0.02 * boxDiagonal(assembly.originalPositions);
		ConstrainedNewtonOptions byDefault;
		byDefault.tuning.closerRounds = 0;
		Positions usual = assembly.originalPositions, positions = usual;
		ASSERT_EQ(constrainedNewton(assembly, usual, byDefault).status, Status::Converged);
		ASSERT_LE(farthestMove(assembly, usual), options.maxDisplacement);
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, Status::Converged);
		EXPECT_LE(farthestMove(assembly, positions), options.maxDisplacement);
		expectSound(assembly, positions);
	}
}

TEST(ConstrainedNewtonParts, OfSewnPanelsKeepToTheirBoundWhenTheyAreStopped) {
	const PatchAssembly assembly = mirroredPatches(25, largeSaddle);
	ConstrainedNewtonOptions options;
	options.maxDisplacement = 0.002 * boxDiagonal(assembly.originalPositions);
	for (const int calls : {3, 10, 20}) {
		Positions positions = assembly.originalPositions;
		int left = calls;
		const auto stop = [&](double, const std::string&) { return --left > 0; };
		EXPECT_EQ(constrainedNewton(assembly, positions, options, stop).status, Status::Stopped);
		EXPECT_LE(farthestMove(assembly, positions), options.maxDisplacement);
	}
}

} // namespace
} // namespace developable::test
