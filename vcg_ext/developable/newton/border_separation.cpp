// SPDX-License-Identifier: GPL-3.0-or-later
// border_separation.cpp: crossings become gaps, and gaps rows of the system.
#include "border_separation.h"

#include "displacement_metric.h"
#include "restoration.h"
#include "restoration_within_bound.h"

#include "developable/geometry/geometry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace developable::detail {

namespace {

constexpr std::size_t mostGaps = 200; ///< each is a solution with the system

/// The shorter way along a closed border from one of two edges to the other, with both.
std::vector<int> wayBetween(const std::vector<int>& border, const FlatBorder& flat,
							const std::array<int, 2>& edges) {
	const int count = static_cast<int>(border.size());
	std::vector<double> begins(1, 0);
	for (int i = 0; i < count; ++i)
		begins.push_back(begins.back() + flat.length(i));
	const BorderWay way = shorterWay(begins, edges[0], edges[1]);
	std::vector<int> halfEdges;
	halfEdges.reserve(way.count);
	for (int i = 0; i < way.count; ++i)
		halfEdges.push_back(border[(way.first + i) % count]);
	return halfEdges;
}

/// Whether the first and the last edge of a way cross. Those of a border that was closed may by rounding
/// where they only touch, as the sides of a dart do that does not open: no end of theirs is to be moved then.
bool endsCross(const FlatBorder& way) {
	const int last = static_cast<int>(way.points().size()) - 2;
	const auto divides = [&](int edge, int other) {
		return way.gap(edge, other) * way.gap(edge, other + 1) < 0;
	};
	return divides(0, last) && divides(last, 0);
}

bool same(const BorderGap& a, const BorderGap& b) {
	return a.halfEdges[a.edge] == b.halfEdges[b.edge] && a.point - a.edge == b.point - b.edge &&
		   a.halfEdges.size() == b.halfEdges.size();
}

bool bordersCross(const PatchAssembly& part, const Positions& positions) {
	const Eigen::VectorXd angles = borderAngles(part, positions);
	const std::vector<std::vector<int>> borders = bordersOfDisks(part);
	return std::any_of(borders.begin(), borders.end(), [&](const std::vector<int>& border) {
		return !border.empty() && !crossingsOf(FlatBorder(part, positions, angles, border).closed()).empty();
	});
}

} // namespace

BorderSeparation::BorderSeparation(NewtonProblem& problem, NewtonRun& run, double bound)
	: problem_(problem), run_(run), bound_(bound), meanEdge_(meanEdgeLength(problem.assembly())),
	  gapScale_(std::sqrt(double(problem.assembly().placeCount())) / meanEdge_),
	  borders_(bordersOfDisks(problem.assembly())), restoring_(problem, run, true, bound),
	  system_(problem.memoryLimit(), problem.metric().eliminationOrder()),
	  firstEpsilon_(problem.tuning().separationEpsilon * restoring_.greatestResponse()),
	  epsilon_(firstEpsilon_) {
	leaveDeepCrossings();
	findCrossings();
}

/// No move within the bound would open them.
void BorderSeparation::leaveDeepCrossings() {
	const PatchAssembly& assembly = problem_.assembly();
	const Eigen::VectorXd angles = borderAngles(assembly, run_.shape().positions);
	for (int patch = 0; patch < assembly.patchCount(); ++patch) {
		if (borders_[patch].empty())
			continue;
		const FlatBorder flat(assembly, run_.shape().positions, angles, borders_[patch]);
		if (longestCoveredStretch(flat.closed()) > problem_.tuning().separationReach * bound_)
			leftAsTheyAre_.insert(patch);
	}
}

/// Gaps that were found before stay as long as they are narrow.
void BorderSeparation::findCrossings() {
	const PatchAssembly& assembly = problem_.assembly();
	const Positions& positions = run_.shape().positions;
	const Eigen::VectorXd angles = borderAngles(assembly, positions), lack = lacks(positions);
	std::vector<BorderGap> narrow;
	for (std::size_t i = 0; i < gaps_.size(); ++i)
		if (lack[Eigen::Index(i)] > -problem_.tuning().separationKept * gapScale_ * meanEdge_)
			narrow.push_back(std::move(gaps_[i]));
	gaps_ = std::move(narrow);
	crossing_.clear();
	for (int patch = 0; patch < assembly.patchCount(); ++patch) {
		if (borders_[patch].empty() || leftAsTheyAre_.count(patch) > 0)
			continue;
		const FlatBorder flat(assembly, positions, angles, borders_[patch]);
		for (const std::array<int, 2>& crossing : crossingsOf(flat.closed())) {
			std::optional<BorderGap> gap = gapOf(borders_[patch], flat, crossing, angles);
			if (!gap)
				continue;
			crossing_.insert(patch);
			const auto isSame = [&](const BorderGap& other) { return same(*gap, other); };
			if (std::none_of(gaps_.begin(), gaps_.end(), isSame))
				gaps_.push_back(std::move(*gap));
		}
	}
}

/// Of the four ends that of least depth, of those that lie on the other edge's side.
std::optional<BorderGap> BorderSeparation::gapOf(const std::vector<int>& border, const FlatBorder& flat,
												 const std::array<int, 2>& crossing,
												 const Eigen::VectorXd& angles) const {
	const std::vector<int> halfEdges = wayBetween(border, flat, crossing);
	const FlatBorder way(problem_.assembly(), run_.shape().positions, angles, halfEdges);
	const int last = static_cast<int>(halfEdges.size()) - 1;
	if (!endsCross(way))
		return {};
	std::optional<BorderGap> gap;
	double least = -std::numeric_limits<double>::infinity();
	for (const auto& [edge, point] :
		 {std::pair(0, last + 1), std::pair(0, last), std::pair(last, 0), std::pair(last, 1)}) {
		const double depth = way.gap(edge, point);
		if (depth >= 0 || depth <= least)
			continue;
		least = depth;
		gap = {halfEdges, edge, point, wantedGap(-depth)};
	}
	return gap;
}

/// As wide as the crossing is deep: what lies there by a hair need not move by more than that.
double BorderSeparation::wantedGap(double depth) const {
	const NewtonTuning& tuning = problem_.tuning();
	return std::clamp(depth, tuning.separationLeastGap * meanEdge_, tuning.separationGap * meanEdge_);
}

Eigen::VectorXd BorderSeparation::lacks(const Positions& positions) const {
	const Eigen::VectorXd angles = borderAngles(problem_.assembly(), positions);
	Eigen::VectorXd result(gaps_.size());
	for (std::size_t i = 0; i < gaps_.size(); ++i) {
		const FlatBorder flat(problem_.assembly(), positions, angles, gaps_[i].halfEdges);
		result[Eigen::Index(i)] = gapScale_ * (gaps_[i].wanted - flat.gap(gaps_[i].edge, gaps_[i].point));
	}
	return result;
}

Ending BorderSeparation::run() {
	if (restoring_.unsolvable())
		return Ending::Unsolvable;
	const Shape begin = run_.shape();
	while (isNeeded()) {
		const Ending ending = moveApart();
		if (ending == Ending::Reached || ending == Ending::Stopped)
			return ending;
		if (isNeeded())
			leftAsTheyAre_.insert(worstPatch());
		run_.goBackTo(begin);
		if (!isNeeded())
			break;
		gaps_.clear();
		findCrossings();
	}
	return Ending::Stuck;
}

/// Steps are cut short for all where one of them can't follow.
int BorderSeparation::worstPatch() const {
	const Eigen::ArrayXd lack = lacks(run_.shape().positions).cwiseMax(0);
	std::vector<double> lackOf(problem_.assembly().patchCount(), 0);
	for (std::size_t i = 0; i < gaps_.size(); ++i)
		lackOf[problem_.assembly().patchOfTriangle[triangleOf(gaps_[i].halfEdges[0])]] +=
			lack[Eigen::Index(i)] * lack[Eigen::Index(i)];
	return *std::max_element(crossing_.begin(), crossing_.end(),
							 [&](int a, int b) { return lackOf[a] < lackOf[b]; });
}

Ending BorderSeparation::moveApart() {
	const NewtonTuning& tuning = problem_.tuning();
	epsilon_ = firstEpsilon_;
	int idle = 0;
	for (int count = 0; count < tuning.separationSteps && gaps_.size() <= mostGaps; ++count) {
		if (!run_.mayGoOn())
			return Ending::Stopped;
		if (!run_.takeStep())
			break;
		const double before = merit(run_.shape());
		epsilon_ = std::max(epsilon_ * restorationFactor(step(), tuning),
							tuning.restorationLeast * restoring_.greatestResponse());
		idle = merit(run_.shape()) > tuning.separationIdle * before ? idle + 1 : 0;
		if (idle == tuning.separationPatience)
			break;
		findCrossings();
		if (isNeeded())
			continue;
		const Ending ending = restoreWithin(problem_, run_, restoring_, bound_);
		if (ending == Ending::Stopped)
			return ending;
		findCrossings();
		if (ending != Ending::Reached || !isNeeded())
			return ending;
		epsilon_ = firstEpsilon_;
	}
	return Ending::Stuck;
}

double BorderSeparation::step() {
	const Eigen::Matrix3Xd coordinates =
		Eigen::Matrix3d::Identity().replicate(1, problem_.assembly().placeCount());
	problem_.jacobian().linearize(run_.shape().positions);
	if (!system_.factorize(problem_.jacobian().matrix(), coordinates, problem_.metric().matrix(), epsilon_) ||
		system_.iterates())
		return 0;
	problem_.budget().spendOperations(system_.operations());
	const Eigen::VectorXd lack = lacks(run_.shape().positions);
	const double slope = -2 * merit(run_.shape());
	return run_.descend(
		whole(lack), [this](const Shape& shape) { return merit(shape); }, slope, problem_.tuning().halvings,
		bound_);
}

/// With A the system without gaps, r what they lack and C their gradients, a step s has
/// (A + CᵀC) s = −Jᵀg + Cᵀr, where C has the rows of those that lack anything or would after the step.
Positions BorderSeparation::whole(const Eigen::VectorXd& lack) {
	const PatchAssembly& assembly = problem_.assembly();
	const Positions& positions = run_.shape().positions;
	const Eigen::VectorXd angles = borderAngles(assembly, positions);
	Eigen::MatrixXd gradients(3 * assembly.placeCount(), gaps_.size() + 1); // and Jᵀg
	for (std::size_t i = 0; i < gaps_.size(); ++i) {
		const FlatBorder flat(assembly, positions, angles, gaps_[i].halfEdges);
		gradients.col(Eigen::Index(i)) =
			gapScale_ * gapGradient(assembly, positions, gaps_[i], flat).reshaped();
	}
	gradients.col(lack.size()) = problem_.jacobian().applyTransposed(run_.shape().scaledDefects).reshaped();
	const Eigen::MatrixXd solved = system_.solve(gradients);
	const Eigen::MatrixXd products = gradients.leftCols(lack.size()).transpose() * solved;
	const Eigen::VectorXd y = multipliers(products, lack);
	const Eigen::VectorXd step = solved.leftCols(lack.size()) * y - solved.col(lack.size());
	return step.reshaped(3, assembly.placeCount());
}

/// Of those that push gaps open; those that would pull them shut are 0.
/// \param products  gaps x gaps, C A⁻¹Cᵀ, and one column more, C A⁻¹Jᵀg
Eigen::VectorXd BorderSeparation::multipliers(const Eigen::MatrixXd& products,
											  const Eigen::VectorXd& lack) const {
	constexpr int rounds = 6;
	const Eigen::Index count = lack.size();
	std::vector<char> active(count);
	for (Eigen::Index i = 0; i < count; ++i)
		active[i] = lack[i] > 0;
	Eigen::VectorXd all = Eigen::VectorXd::Zero(count);
	for (int round = 0; round < rounds; ++round) {
		std::vector<int> rows;
		for (Eigen::Index i = 0; i < count; ++i)
			if (active[i])
				rows.push_back(static_cast<int>(i));
		const auto size = Eigen::Index(rows.size());
		const Eigen::MatrixXd small = products(rows, rows) + Eigen::MatrixXd::Identity(size, size);
		const Eigen::VectorXd aims = lack(rows) + products.col(count)(rows);
		all.setZero();
		all(rows) = Eigen::VectorXd(small.llt().solve(aims));
		const Eigen::VectorXd after = lack + products.col(count) - products.leftCols(count) * all;
		std::vector<char> next(count);
		for (Eigen::Index i = 0; i < count; ++i)
			next[i] = active[i] ? all[i] > 0 : after[i] > 0;
		if (next == active)
			break;
		active = std::move(next);
	}
	return all.cwiseMax(0);
}

void separateBorders(const PatchAssembly& part, const ConstrainedNewtonOptions& options,
					 const CurvatureGoal& goal, NewtonOutcome& outcome, const Progress& progress) {
	const NewtonTuning& tuning = options.tuning;
	if (tuning.separationSteps == 0 || part.placeCount() > tuning.returnPlacesTogether || holdsPlaces(part) ||
		!bordersCross(part, outcome.positions))
		return;
	NewtonProblem problem(part, goal, tuning, options.memoryLimit);
	problem.setBudget(std::make_shared<WorkBudget>(tuning.separationWorkPerPlace * part.placeCount()));
	problem.setSmoothness(options.smoothness);
	problem.jacobian().freeBorders(true);
	NewtonRun run(problem, outcome.positions, options.maxIterations, progress);
	const double near = std::max(run.shape().farthest, problem.preferredMove());
	BorderSeparation separation(problem, run, std::min(near, goal.farthest));
	if (separation.isNeeded() && separation.run() == Ending::Stopped)
		outcome.ending = Ending::Stopped;
	outcome.iterations += run.iterations();
	outcome.work += problem.budget().used();
	if (run.shape().reached)
		outcome.positions = run.shape().positions;
}

} // namespace developable::detail
