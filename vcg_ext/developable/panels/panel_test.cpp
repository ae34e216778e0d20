// SPDX-License-Identifier: GPL-3.0-or-later
// panel_test.cpp: topology first, then the constrained Newton method, then the plane.
#include "panel_test.h"

#include "border_parts.h"

#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/newton/constrained_newton.h"

#include <cmath>

namespace developable::detail {

namespace {

constexpr double meanOnWay = 1.05;      ///< shapes that hold hardly ever have been farther from the original
constexpr double greatestStrain = 1e-3; ///< of a developable panel laid flat: C ≤ 1e-4 leaves far less
constexpr double workOnTriangle = 3;    ///< of a mesh that is put together, made coarser and looked at

bool isDisk(const PatchAssembly& assembly) {
	return assembly.patchCount() == 1 && assembly.patches[0].orientable &&
		   assembly.patches[0].eulerCharacteristic() == 1 && !assembly.patches[0].closed();
}

/// A single open sheet, with holes perhaps, that flattening can take.
bool isSheet(const PatchAssembly& assembly) {
	return assembly.patchCount() == 1 && assembly.patches[0].orientable && !assembly.patches[0].closed() &&
		   assembly.interiorCopyCount() < assembly.copyCount();
}

/// Long runs are for shapes that a user asks for: what a panel needs is near. Borders may kink: they still
/// are jagged, and smooth ones need less.
ConstrainedNewtonOptions briefRun(const PanelLimits& limits) {
	constexpr double farthestOnWay = 2;
	ConstrainedNewtonOptions options;
	options.maxIterations = 120;
	options.maxDisplacement = limits.maxDisplacement;
	options.tuning.wayMean = meanOnWay * limits.meanDisplacement / limits.maxDisplacement;
	options.tuning.wayFarthest = farthestOnWay;
	options.tuning.limitedSteps = 0;
	options.tuning.leastSquares = 0;
	options.tuning.curvatureSteps = 0;
	options.tuning.separationSteps = 0;
	options.tuning.preferredMove = 0;
	return options;
}

Eigen::Vector3d worstPoint(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Index worst = 0;
	angleDefects(assembly, positions).cwiseAbs().maxCoeff(&worst);
	return assembly.originalPositions.col(assembly.placeOfCopy[worst]);
}

Eigen::Vector3d farthestPoint(const PatchAssembly& assembly, const Positions& positions) {
	Eigen::Index farthest = 0;
	(positions - assembly.originalPositions).colwise().squaredNorm().maxCoeff(&farthest);
	return assembly.originalPositions.col(farthest);
}

bool overlapsLittle(const FlatPatterns& patterns, double notch) {
	const FlatPiece& piece = patterns.pieces.front();
	return !piece.overlapping ||
		   (!piece.crossings.empty() && largestNotch(notchesOf(patterns, piece)).share <= notch);
}

bool liesFlat(const PatchAssembly& assembly, const Positions& positions, double notch) {
	const FlatPatterns patterns = flattenPatches(assembly, positions);
	const FlatPiece& piece = patterns.pieces.front();
	return overlapsLittle(patterns, notch) && piece.cuts == 0 && piece.flippedFaces == 0 &&
		   piece.maxEdgeStrain < greatestStrain;
}

/// \return whether the places have moved no farther than they may
bool isNear(const PatchAssembly& assembly, const Positions& positions, const PanelLimits& limits,
			PanelVerdict& verdict) {
	const Eigen::VectorXd moves = displacementMap(assembly.originalPositions, positions);
	verdict.maxDisplacement = moves.maxCoeff();
	verdict.meanDisplacement = moves.mean();
	return verdict.maxDisplacement <= limits.maxDisplacement &&
		   verdict.meanDisplacement <= limits.meanDisplacement;
}

/// A smooth shape that becomes developable is bent about as much as it was. One that is too much curved gets
/// there by folds, and more of them among others that pull at it, or with more triangles.
bool crumples(const PatchAssembly& assembly, const Positions& positions) {
	constexpr double mostBent = 1.8; // beside the original
	constexpr double bendOfFlat = 1; // across what is flat, rad
	const double side = std::sqrt(copyAreas(assembly, assembly.originalPositions).sum());
	return meanAbsoluteCurvature(assembly, positions) >
		   mostBent * meanAbsoluteCurvature(assembly, assembly.originalPositions) + bendOfFlat * side / 2;
}

void testOnLevel(const PatchAssembly& assembly, const PanelLimits& limits, const Progress& progress,
				 PanelVerdict& verdict) {
	Positions positions = assembly.originalPositions;
	verdict.worstPoint = worstPoint(assembly, positions);
	const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, briefRun(limits), progress);
	verdict.work += report.work;
	const bool near = isNear(assembly, positions, limits, verdict);
	verdict.obstacle = Obstacle::TooFar; // so it is what goes on to somewhere else, and ends on the way
	if (!converged(report.status)) {
		verdict.worstPoint = worstPoint(assembly, positions);
		return;
	}
	const bool crumpled = near && crumples(assembly, positions);
	if (!near || crumpled) {
		verdict.worstPoint = farthestPoint(assembly, positions);
		verdict.obstacle = crumpled ? Obstacle::Crumples : Obstacle::TooFar;
		return;
	}
	verdict.flat = liesFlat(assembly, positions, limits.notch);
	verdict.obstacle = verdict.flat ? Obstacle::None : Obstacle::Overlaps;
}

/// How far a shape has to move shows with few places.
PatchAssembly coarseEnough(PatchAssembly assembly) {
	constexpr int enough = 400;
	constexpr double worthWhile = 1.3; // times as many
	if (assembly.placeCount() > worthWhile * enough)
		return coarserLevel(assembly, enough).assembly;
	return assembly;
}

/// A dome of height h over a width w strains its layout by about (h/w)², and has to move by a share of h.
/// On 2356 unions of panels of ten shapes: of those that hold, 98 % overlap less and 98 % are less strained.
bool isPromising(const PatchAssembly& coarse, const PanelLimits& limits) {
	constexpr int fewPlaces = 100;          // are tested as soon
	constexpr double greatestOverlap = 0.1; // share of the border
	constexpr double greatestHeight = 8.3;  // share of how far places may move
	if (coarse.placeCount() < fewPlaces)
		return true;
	FlattenOptions first;
	first.iterations = 1;
	first.threads = 1;
	const FlatPatterns patterns = flattenPatches(coarse, coarse.originalPositions, first);
	const FlatPiece& piece = patterns.pieces.front();
	if (!overlapsLittle(patterns, greatestOverlap))
		return false;
	const double height = std::sqrt(piece.meanEdgeStrain) * boxDiagonal(coarse.originalPositions);
	return limits.material.bounds.any() || height <= greatestHeight * limits.maxDisplacement;
}

void testStrained(const PatchAssembly& assembly, const PatchAssembly& coarse, const PanelLimits& limits,
				  const Progress& progress, PanelVerdict& verdict) {
	const Outlook outlook = outlookOf(assembly, limits.material, limits.maxDisplacement);
	if (outlook == Outlook::MostlyMoves)
		testOnLevel(coarse, limits, progress, verdict); // which is quicker
	if (verdict.flat)
		return;
	verdict.obstacle = Obstacle::BeyondBounds;
	if (outlook == Outlook::Hopeless)
		return;
	verdict.work += workOnStrain * assembly.triangleCount();
	Positions positions = assembly.originalPositions;
	const BoundedSearch search{limits.maxDisplacement, meanOnWay * limits.meanDisplacement, true};
	const PatternVerdict pattern =
		bringWithinBounds(assembly, positions, limits.material, search, progress).front();
	verdict.flat = isNear(assembly, positions, limits, verdict) && pattern.holds();
	if (verdict.flat)
		verdict.obstacle = Obstacle::None;
}

PanelVerdict test(const TriangleMesh& mesh, const PanelLimits& limits, bool onlyIfPromising,
				  const Progress& progress) {
	PanelVerdict verdict;
	verdict.work = workOnTriangle * mesh.triangleCount();
	const PatchAssembly assembly = assemblePatches(mesh, {});
	if (!isSheet(assembly)) {
		verdict.obstacle = Obstacle::NoSheet;
		return verdict;
	}
	verdict.disk = isDisk(assembly);
	try {
		const PatchAssembly coarse = coarseEnough(assembly);
		if (onlyIfPromising && verdict.disk && !isPromising(coarse, limits))
			verdict.obstacle = Obstacle::Unpromising;
		else if (limits.material.bounds.any())
			testStrained(assembly, coarse, limits, progress, verdict);
		else
			testOnLevel(coarse, limits, progress, verdict);
	} catch (const PatchWithHandles&) {
		verdict.flat = false;
		verdict.obstacle = Obstacle::NoSheet;
	}
	return verdict;
}

} // namespace

bool isDisk(const TriangleMesh& mesh) {
	return isDisk(assemblePatches(mesh, {}));
}

PanelVerdict testPanel(const TriangleMesh& mesh, const PanelLimits& limits, const Progress& progress) {
	return test(mesh, limits, false, progress);
}

PanelVerdict testIfPromising(const TriangleMesh& mesh, const PanelLimits& limits, const Progress& progress) {
	return test(mesh, limits, true, progress);
}

} // namespace developable::detail
