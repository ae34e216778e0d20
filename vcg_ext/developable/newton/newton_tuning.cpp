// SPDX-License-Identifier: GPL-3.0-or-later
// newton_tuning.cpp: the constants by name.
#include "newton_tuning.h"

#include <algorithm>
#include <cmath>

namespace developable {

double TuningConstant::value(const NewtonTuning& tuning) const {
	return std::visit([&](auto constant) { return static_cast<double>(tuning.*constant); }, member);
}

void TuningConstant::set(NewtonTuning& tuning, double value) const {
	if (const auto* whole = std::get_if<int NewtonTuning::*>(&member))
		tuning.** whole = std::max(1, static_cast<int>(std::lround(value)));
	else
		tuning.*std::get<double NewtonTuning::*>(member) = value;
}

namespace {

/// Of the metric and of each kind of step.
std::vector<TuningConstant> constantsOfSteps() {
	return {
		{"borderStiffness", &NewtonTuning::borderStiffness},
		{"borderTurn", &NewtonTuning::borderTurn},
		{"limitedSteps", &NewtonTuning::limitedSteps},
		{"foresights", &NewtonTuning::foresights},
		{"fairSteps", &NewtonTuning::fairSteps},
		{"fairPlaces", &NewtonTuning::fairPlaces},
		{"fairRounds", &NewtonTuning::fairRounds},
		{"fairAimSteps", &NewtonTuning::fairAimSteps},
		{"fairEpsilon", &NewtonTuning::fairEpsilon},
		{"fairRestoration", &NewtonTuning::fairRestoration},
		{"fairHalvings", &NewtonTuning::fairHalvings},
		{"fairGain", &NewtonTuning::fairGain},
		{"fairPatience", &NewtonTuning::fairPatience},
		{"detailWave", &NewtonTuning::detailWave},
		{"detailSteps", &NewtonTuning::detailSteps},
		{"detailCurvature", &NewtonTuning::detailCurvature},
		{"detailLikeness", &NewtonTuning::detailLikeness},
		{"detailMove", &NewtonTuning::detailMove},
		{"firstEpsilon", &NewtonTuning::firstEpsilon},
		{"leastEpsilon", &NewtonTuning::leastEpsilon},
		{"epsilonDecrease", &NewtonTuning::epsilonDecrease},
		{"slowDecrease", &NewtonTuning::slowDecrease},
		{"noDecrease", &NewtonTuning::noDecrease},
		{"settledCurvature", &NewtonTuning::settledCurvature},
		{"settledDistance", &NewtonTuning::settledDistance},
		{"systemResidual", &NewtonTuning::systemResidual},
		{"farPlace", &NewtonTuning::farPlace},
		{"farSharpness", &NewtonTuning::farSharpness},
		{"farMost", &NewtonTuning::farMost},
		{"togetherMean", &NewtonTuning::togetherMean},
		{"togetherSteps", &NewtonTuning::togetherSteps},
		{"restorationPatience", &NewtonTuning::restorationPatience},
		{"restorationIdle", &NewtonTuning::restorationIdle},
		{"restorationDecrease", &NewtonTuning::restorationDecrease},
		{"restorationIncrease", &NewtonTuning::restorationIncrease},
		{"restorationRetry", &NewtonTuning::restorationRetry},
		{"restorationLeast", &NewtonTuning::restorationLeast},
		{"restorationLeastHeldUp", &NewtonTuning::restorationLeastHeldUp},
		{"restorationReview", &NewtonTuning::restorationReview},
		{"restorationSlow", &NewtonTuning::restorationSlow},
		{"restorationShortStep", &NewtonTuning::restorationShortStep},
		{"nearlyThere", &NewtonTuning::nearlyThere},
	};
}

/// Of the shortest steps, those along the normals, and local ones.
std::vector<TuningConstant> constantsOfNormalSteps() {
	return {
		{"shortestMove", &NewtonTuning::shortestMove},
		{"shortestSteps", &NewtonTuning::shortestSteps},
		{"shortestPatience", &NewtonTuning::shortestPatience},
		{"shortestForesight", &NewtonTuning::shortestForesight},
		{"shortestDamping", &NewtonTuning::shortestDamping},
		{"nearCurvature", &NewtonTuning::nearCurvature},
		{"nearMove", &NewtonTuning::nearMove},
		{"nearSteps", &NewtonTuning::nearSteps},
		{"firstDamping", &NewtonTuning::firstDamping},
		{"normalPatience", &NewtonTuning::normalPatience},
		{"normalIdle", &NewtonTuning::normalIdle},
		{"normalGood", &NewtonTuning::normalGood},
		{"normalVeryGood", &NewtonTuning::normalVeryGood},
		{"normalDecrease", &NewtonTuning::normalDecrease},
		{"normalFastDecrease", &NewtonTuning::normalFastDecrease},
		{"normalSlowDecrease", &NewtonTuning::normalSlowDecrease},
		{"normalIncrease", &NewtonTuning::normalIncrease},
		{"normalRetry", &NewtonTuning::normalRetry},
		{"normalShortStep", &NewtonTuning::normalShortStep},
		{"normalHalvings", &NewtonTuning::normalHalvings},
		{"curvatureSteps", &NewtonTuning::curvatureSteps},
		{"curvatureWorkPerPlace", &NewtonTuning::curvatureWorkPerPlace},
		{"curvatureSharpening", &NewtonTuning::curvatureSharpening},
		{"curvatureSharpest", &NewtonTuning::curvatureSharpest},
		{"curvatureIdle", &NewtonTuning::curvatureIdle},
		{"curvatureGood", &NewtonTuning::curvatureGood},
		{"localPlaces", &NewtonTuning::localPlaces},
		{"localRows", &NewtonTuning::localRows},
		{"coarseLocalRows", &NewtonTuning::coarseLocalRows},
		{"localRings", &NewtonTuning::localRings},
		{"localSteps", &NewtonTuning::localSteps},
		{"localRounds", &NewtonTuning::localRounds},
		{"localShare", &NewtonTuning::localShare},
		{"localGood", &NewtonTuning::localGood},
	};
}

/// Of what holds for all steps.
std::vector<TuningConstant> constantsOfAllSteps() {
	return {
		{"halvings", &NewtonTuning::halvings},
		{"chords", &NewtonTuning::chords},
		{"chordShare", &NewtonTuning::chordShare},
		{"sparingRounds", &NewtonTuning::sparingRounds},
		{"responseSteps", &NewtonTuning::responseSteps},
		{"systemSteps", &NewtonTuning::systemSteps},
		{"slowSystem", &NewtonTuning::slowSystem},
		{"slowStiffSystem", &NewtonTuning::slowStiffSystem},
		{"foreseenWork", &NewtonTuning::foreseenWork},
		{"dearPreconditioner", &NewtonTuning::dearPreconditioner},
		{"plainAbove", &NewtonTuning::plainAbove},
		{"slackMass", &NewtonTuning::slackMass},
		{"stiffenings", &NewtonTuning::stiffenings},
		{"firstStiffness", &NewtonTuning::firstStiffness},
		{"stiffnessIncrease", &NewtonTuning::stiffnessIncrease},
		{"stiffShare", &NewtonTuning::stiffShare},
		{"stiffTriangles", &NewtonTuning::stiffTriangles},
		{"sliverShare", &NewtonTuning::sliverShare},
		{"sliverAngle", &NewtonTuning::sliverAngle},
		{"sliverMargin", &NewtonTuning::sliverMargin},
		{"symmetryBreaking", &NewtonTuning::symmetryBreaking},
		{"symmetryWaves", &NewtonTuning::symmetryWaves},
	};
}

/// Of the bounds on displacements.
std::vector<TuningConstant> constantsOfBounds() {
	return {
		{"returnRounds", &NewtonTuning::returnRounds},
		{"returnSteps", &NewtonTuning::returnSteps},
		{"returnCurvature", &NewtonTuning::returnCurvature},
		{"returnDecrease", &NewtonTuning::returnDecrease},
		{"returnRestoration", &NewtonTuning::returnRestoration},
		{"returnGain", &NewtonTuning::returnGain},
		{"returnPatience", &NewtonTuning::returnPatience},
		{"returnAim", &NewtonTuning::returnAim},
		{"returnWeight", &NewtonTuning::returnWeight},
		{"returnWeightTogether", &NewtonTuning::returnWeightTogether},
		{"boundWeight", &NewtonTuning::boundWeight},
		{"boundWeightIncrease", &NewtonTuning::boundWeightIncrease},
		{"boundSharpness", &NewtonTuning::boundSharpness},
		{"boundAim", &NewtonTuning::boundAim},
		{"boundRounds", &NewtonTuning::boundRounds},
		{"heavyPlace", &NewtonTuning::heavyPlace},
		{"returnReach", &NewtonTuning::returnReach},
		{"preferredMove", &NewtonTuning::preferredMove},
		{"preferredLength", &NewtonTuning::preferredLength},
		{"beyondPreferred", &NewtonTuning::beyondPreferred},
		{"closerFrom", &NewtonTuning::closerFrom},
		{"closerReach", &NewtonTuning::closerReach},
		{"closerStep", &NewtonTuning::closerStep},
		{"closerRounds", &NewtonTuning::closerRounds},
		{"closerWorkPerPlace", &NewtonTuning::closerWorkPerPlace},
		{"otherLevels", &NewtonTuning::otherLevels},
		{"otherLevelWork", &NewtonTuning::otherLevelWork},
		{"workBeforeOthers", &NewtonTuning::workBeforeOthers},
		{"wayFarthest", &NewtonTuning::wayFarthest},
		{"wayMean", &NewtonTuning::wayMean},
		{"returnPlaces", &NewtonTuning::returnPlaces},
		{"returnPlacesTogether", &NewtonTuning::returnPlacesTogether},
		{"preferredPrice", &NewtonTuning::preferredPrice},
		{"preferredReach", &NewtonTuning::preferredReach},
		{"preferredReachBeforeOthers", &NewtonTuning::preferredReachBeforeOthers},
		{"preferredCurvature", &NewtonTuning::preferredCurvature},
		{"preferredWork", &NewtonTuning::preferredWork},
		{"preferredWorkPerPlace", &NewtonTuning::preferredWorkPerPlace},
		{"goOnBeyond", &NewtonTuning::goOnBeyond},
		{"pullBackReach", &NewtonTuning::pullBackReach},
		{"pullBackShare", &NewtonTuning::pullBackShare},
		{"pullBackRounds", &NewtonTuning::pullBackRounds},
		{"pullBackSteps", &NewtonTuning::pullBackSteps},
		{"separationSteps", &NewtonTuning::separationSteps},
		{"separationReach", &NewtonTuning::separationReach},
		{"separationGap", &NewtonTuning::separationGap},
		{"separationLeastGap", &NewtonTuning::separationLeastGap},
		{"separationKept", &NewtonTuning::separationKept},
		{"separationEpsilon", &NewtonTuning::separationEpsilon},
		{"separationIdle", &NewtonTuning::separationIdle},
		{"separationPatience", &NewtonTuning::separationPatience},
		{"separationWorkPerPlace", &NewtonTuning::separationWorkPerPlace},
		{"leastSquares", &NewtonTuning::leastSquares},
		{"leastSquaresSteps", &NewtonTuning::leastSquaresSteps},
	};
}

/// Of the strategy.
std::vector<TuningConstant> constantsOfStrategy() {
	return {
		{"workPerPlace", &NewtonTuning::workPerPlace},
		{"workOnSmall", &NewtonTuning::workOnSmall},
		{"reserveOfCareful", &NewtonTuning::reserveOfCareful},
		{"reserveOfCoarse", &NewtonTuning::reserveOfCoarse},
		{"workTogether", &NewtonTuning::workTogether},
		{"workOfOthers", &NewtonTuning::workOfOthers},
		{"workBeforeNext", &NewtonTuning::workBeforeNext},
		{"coarsest", &NewtonTuning::coarsest},
		{"coarsestTogether", &NewtonTuning::coarsestTogether},
		{"levelRatio", &NewtonTuning::levelRatio},
		{"coarseRoom", &NewtonTuning::coarseRoom},
		{"leastReduction", &NewtonTuning::leastReduction},
		{"fineSmoothness", &NewtonTuning::fineSmoothness},
		{"prolongationBending", &NewtonTuning::prolongationBending},
		{"prolongationMass", &NewtonTuning::prolongationMass},
		{"coarseShortening", &NewtonTuning::coarseShortening},
		{"coarseShare", &NewtonTuning::coarseShare},
		{"coarseTurn", &NewtonTuning::coarseTurn},
		{"coarseCotangent", &NewtonTuning::coarseCotangent},
		{"coarseFan", &NewtonTuning::coarseFan},
	};
}

std::vector<TuningConstant> joined(const std::vector<std::vector<TuningConstant>>& groups) {
	std::vector<TuningConstant> all;
	for (const std::vector<TuningConstant>& constants : groups)
		all.insert(all.end(), constants.begin(), constants.end());
	return all;
}

} // namespace

const std::vector<TuningConstant>& tuningConstants() {
	static const std::vector<TuningConstant> constants =
		joined({constantsOfSteps(), constantsOfNormalSteps(), constantsOfAllSteps(), constantsOfBounds(),
				constantsOfStrategy()});
	return constants;
}

} // namespace developable
