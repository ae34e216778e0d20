// SPDX-License-Identifier: GPL-3.0-or-later
// local_steps.cpp: where the worst rows are, and the parts round them, each by itself.
#include "local_steps.h"

#include "normal_steps.h"

#include <algorithm>
#include <numeric>

namespace developable::detail {

namespace {

/// Whether a triangle has a marked place.
bool touches(const PatchAssembly& assembly, int triangle, const std::vector<char>& marked) {
	const auto places = assembly.trianglePlaces.col(triangle);
	return std::any_of(places.begin(), places.end(), [&](int place) { return marked[place] != 0; });
}

/// The places of all triangles that have a marked one.
std::vector<char> withNeighbours(const PatchAssembly& assembly, const std::vector<char>& marked) {
	std::vector<char> result = marked;
	for (int t = 0; t < assembly.triangleCount(); ++t)
		if (touches(assembly, t, marked))
			for (const int place : assembly.trianglePlaces.col(t))
				result[place] = 1;
	return result;
}

/// The triangles round all copies whose angle defects depend on some places. These are free, the others held
/// still.
PartialAssembly surroundingsOf(const PatchAssembly& assembly, const std::vector<char>& free) {
	const std::vector<char> responding = withNeighbours(assembly, free);
	PartialAssembly part = partialAssembly(assembly, trianglesWhere(assembly.triangleCopies, [&](int t) {
											   return touches(assembly, t, responding);
										   }));
	for (int place = 0; place < part.assembly.placeCount(); ++place)
		if (!free[part.wholePlace[place]])
			part.assembly.placeFixed[place] = 1;
	return part;
}

/// In which the places of each part are eliminated: as they are among those of the whole.
std::vector<std::vector<int>> ordersOf(const std::vector<AssemblyPart>& parts,
									   const std::vector<int>& wholePlace,
									   const std::vector<int>& wholeOrder) {
	std::vector<int> rank(wholeOrder.size());
	for (std::size_t i = 0; i < wholeOrder.size(); ++i)
		rank[wholeOrder[i]] = static_cast<int>(i);
	std::vector<std::vector<int>> orders;
	orders.reserve(parts.size());
	for (const AssemblyPart& part : parts) {
		std::vector<int>& order = orders.emplace_back(part.wholePlace.size());
		std::iota(order.begin(), order.end(), 0);
		std::sort(order.begin(), order.end(), [&](int a, int b) {
			return rank[wholePlace[part.wholePlace[a]]] < rank[wholePlace[part.wholePlace[b]]];
		});
	}
	return orders;
}

} // namespace

double LocalSteps::step(NewtonRun& run, const Positions& whole, double may) const {
	const double before = run.shape().squaredDefects();
	const std::optional<Shape> ahead = run.ahead(whole, farthest_);
	if (!ahead || ahead->squaredDefects() <= may * before)
		return 0;
	const std::optional<Shape> after = improved(*ahead, before);
	return after ? run.descendDefects(after->positions - run.shape().positions, 0, farthest_) : 0;
}

std::optional<Shape> LocalSteps::improved(Shape ahead, double before) const {
	const NewtonTuning& tuning = problem_.tuning();
	std::optional<Shape> best;
	for (int round = 0; round < tuning.localRounds && ahead.squaredDefects() > tuning.normalGood * before;
		 ++round) {
		const std::vector<int> rows = worstRows(ahead, before);
		if (rows.empty())
			break;
		Shape after = afterRound(ahead, rows);
		const double left = after.squaredDefects() / ahead.squaredDefects();
		if (left < 1)
			best = after;
		if (!(left < tuning.localShare))
			break;
		ahead = std::move(after);
	}
	return best;
}

std::vector<int> LocalSteps::worstRows(const Shape& shape, double before) const {
	const NewtonTuning& tuning = problem_.tuning();
	const Eigen::VectorXd squares = shape.scaledDefects.cwiseAbs2();
	std::vector<int> rows(squares.size());
	std::iota(rows.begin(), rows.end(), 0);
	const auto most = static_cast<std::ptrdiff_t>(tuning.localRows * static_cast<double>(rows.size()));
	std::partial_sort(rows.begin(), rows.begin() + most, rows.end(), [&](int a, int b) {
		return squares[a] != squares[b] ? squares[a] > squares[b] : a < b;
	});
	double rest = squares.sum();
	std::ptrdiff_t count = 0;
	while (count < most && rest > tuning.normalVeryGood * before)
		rest -= squares[rows[count++]];
	rows.resize(rest > tuning.normalGood * before ? 0 : count);
	return rows;
}

Shape LocalSteps::afterRound(const Shape& shape, const std::vector<int>& rows) const {
	const PatchAssembly& assembly = problem_.assembly();
	std::vector<char> free(assembly.placeCount(), 0);
	for (const int row : rows)
		free[problem_.jacobian().placeOfRow(row)] = 1;
	for (int ring = 0; ring < problem_.tuning().localRings; ++ring)
		free = withNeighbours(assembly, free);
	const PartialAssembly surroundings = surroundingsOf(assembly, free);
	const Positions from = shape.positions(Eigen::all, surroundings.wholePlace);
	const std::vector<AssemblyPart> parts = partsOf(surroundings.assembly);
	std::vector<std::vector<int>> orders =
		ordersOf(parts, surroundings.wholePlace, problem_.metric().eliminationOrder());
	std::vector<WorkBudget> work(parts.size());
	std::vector<Positions> found(parts.size());
	std::vector<Task> tasks;
	tasks.reserve(parts.size());
	for (std::size_t i = 0; i < parts.size(); ++i)
		tasks.push_back({double(parts[i].assembly.placeCount()), [&, i](const Progress&) {
							 found[i] = stepsOf(parts[i], std::move(orders[i]),
												from(Eigen::all, parts[i].wholePlace), work[i]);
						 }});
	runTasks(tasks, 0, {});
	Positions positions = from;
	for (std::size_t i = 0; i < parts.size(); ++i) {
		problem_.budget().spend(work[i]);
		positions(Eigen::all, parts[i].wholePlace) = found[i];
	}
	Positions whole = shape.positions;
	whole(Eigen::all, surroundings.wholePlace) = positions;
	return problem_.shapeAt(whole);
}

Positions LocalSteps::stepsOf(const AssemblyPart& part, std::vector<int> order, const Positions& from,
							  WorkBudget& work) const {
	CurvatureGoal goal = problem_.goal();
	goal.curvatureTolerance *= double(part.assembly.placeCount()) / problem_.assembly().placeCount();
	NewtonProblem problem(part.assembly, goal, problem_.tuning(), problem_.memoryLimit());
	problem.metric().eliminateIn(std::move(order));
	problem.setSmoothness(0); // on so small an area it counts for nothing, and is dear to find
	problem.jacobian().freeBorders(true);
	const Progress silent;
	NewtonRun run(problem, from, problem_.tuning().localSteps, silent);
	NormalSteps(problem, run, farthest_).run();
	work = problem.budget();
	return run.shape().positions;
}

} // namespace developable::detail
