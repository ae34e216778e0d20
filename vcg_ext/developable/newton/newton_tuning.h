// SPDX-License-Identifier: GPL-3.0-or-later
// newton_tuning.h: the constants of the constrained Newton method that were found by trial.
//
// `bash bench/run.sh ablation` shows for each what becomes of success, nearness and time when it is a quarter
// of its value, and four times.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace developable {

/// Shares and factors have no unit. Every constant is named in tuningConstants().
struct NewtonTuning {
	// The metric.
	double borderStiffness = 0.3; ///< β / α: how dear it is to bend a border beside bending the surface
	double borderTurn = 4.8;      ///< degrees that a border may turn by more than before
	int limitedSteps = 100;       ///< until borders may turn as they like
	int foresights = 2;           ///< in a step: times that limits are added which it would exceed

	// Fairness.
	int fairSteps = 5;             ///< from the original to its fair shape
	int fairPlaces = 6000;         ///< more: the way to fairer developable shapes is left to a coarser level
	int fairRounds = 10;           ///< on this way
	int fairAimSteps = 2;          ///< in a round, before the restoration
	double fairEpsilon = 0.01;     ///< of these steps, share of the greatest response
	double fairRestoration = 1e-3; ///< the same, where the restoration begins
	int fairHalvings = 4;          ///< of a round's step
	double fairGain = 0.01;        ///< share of the unfairness: less is next to nothing
	int fairPatience = 2;          ///< rounds in a row that gain next to nothing

	// Noise and fine detail of panels that are sewn together, which they begin without.
	double detailWave = 3;         ///< of the longest waves that go, in mean edge lengths
	int detailSteps = 3;           ///< of smoothing at most
	double detailCurvature = 0.65; ///< share of the curvature that each leaves at most
	double detailLikeness = 0.2;   ///< between -1 and 1, of what goes at neighbours, at most
	double detailMove = 0.25;      ///< share of how far places may move, that they are moved by at most

	// Continuation in ε: from the original to where next to nothing of the curvature is left.
	double firstEpsilon = 0.25; ///< share of the greatest response of g to a force: begins near the original
	double leastEpsilon = 4e-5; ///< share of the first: below it, rounding makes the systems' solutions
	double epsilonDecrease = 0.25;  ///< factor: less asks for more steps, more for longer line searches
	double slowDecrease = 0.3;      ///< of φ in a full step: less than that means that ε holds it up
	double noDecrease = 0.01;       ///< of φ in any step: less than that means the same
	double settledCurvature = 0.03; ///< share of C at the start that restoration may be left with
	double settledDistance = 0.05;  ///< change of ‖d‖² in a step: less means that nearness is found
	double systemResidual = 0.05;   ///< what is left of a system: the next step corrects it

	// The continuation of panels that are sewn together, within how far a place had better move.
	double farPlace = 5;       ///< of its mass, that a place so far away is heavier by
	double farSharpness = 8;   ///< power of the displacement's share of that move, which it is heavier by
	double farMost = 2.5;      ///< of that share, where it is no heavier any more
	int togetherSteps = 50;    ///< until that is given up
	double togetherMean = 0.4; ///< share of that move that places may have on average, if some are beyond it

	// Restoration: the shortest steps to g = 0.
	int restorationPatience = 5;      ///< steps in a row that change next to nothing
	double restorationIdle = 0.99;    ///< share of |g|² that is left by a step that changes next to nothing
	double restorationDecrease = 0.1; ///< of ε after a full step: Newton's method converges quadratically
	double restorationIncrease = 4;   ///< of ε after a short step
	double restorationRetry = 16;     ///< of ε when no step was any good
	double restorationLeast = 1e-8; ///< ε, share of the greatest response: below it rounding makes the steps
	double restorationLeastHeldUp = 1e-12; ///< the same where whole steps leave much at that
	int restorationReview = 8;             ///< steps in a row that are judged together
	double restorationSlow = 0.5;          ///< share of |g|² that those may leave: success halves it in each
	double restorationShortStep = 0.25;    ///< length below which a step is short

	double nearlyThere = 0.3; ///< share of C at the start from which a restoration goes on more freely

	// Shortest steps, for what is developable but for rounding.
	double shortestMove = 1e-3;    ///< share of the shortest edge that a place may move by
	int shortestSteps = 30;        ///< until that is given up
	int shortestPatience = 3;      ///< steps in a row that are no good
	int shortestForesight = 30;    ///< of conjugate gradients, which may show beforehand that it takes more
	double shortestDamping = 1e-3; ///< of the first, share of the mean diagonal of J M⁻¹ Jᵀ

	// Steps along the normals from the original itself, for what is all but developable.
	double nearCurvature = 100; ///< times what is allowed in the end
	double nearMove = 1e-3;     ///< share of the diagonal that a place may move by
	int nearSteps = 6;          ///< until that is given up

	// Steps along the normals.
	double firstDamping = 0.01;      ///< share of ‖N u‖²_W in the trace of the first system
	int normalPatience = 5;          ///< steps in a row that change next to nothing
	double normalIdle = 0.98;        ///< share of |g|² that is left by a step that changes next to nothing
	double normalGood = 0.5;         ///< share of |g|² that a good step leaves at most
	double normalVeryGood = 0.1;     ///< and a very good one
	double normalDecrease = 0.3;     ///< of ε after a good step
	double normalFastDecrease = 0.1; ///< after a very good one
	double normalSlowDecrease = 0.5; ///< after a full step that was neither
	double normalIncrease = 4;       ///< after a short step
	double normalRetry = 16;         ///< when no step was any good
	double normalShortStep = 0.3;    ///< length below which a step is short
	int normalHalvings = 7;          ///< of a step until ε is raised instead

	// Steps along the normals to the least curvature, where there is no way to none.
	int curvatureSteps = 30;            ///< 0: none are taken
	double curvatureWorkPerPlace = 400; ///< in units of WorkBudget
	double curvatureSharpening = 0.7;   ///< of δ from a step to the next; it begins with the mean |g|
	double curvatureSharpest = 0.01;    ///< share of that
	double curvatureIdle = 0.995;       ///< share of C that is left by a step that changes next to nothing
	double curvatureGood = 0.9;         ///< share of C that a good step leaves at most

	// Local steps, where a whole step leaves too much near few places.
	int localPlaces = 20000;       ///< more, for steps along the normals: fewer are quick without
	double localRows = 0.1;        ///< share of all rows: more are not local
	double coarseLocalRows = 0.03; ///< the same on coarser levels, which the shape's large features are from
	int localRings = 2;            ///< round a row's place, that move
	int localSteps = 4;            ///< in a round
	int localRounds = 4;           ///< after a step
	double localShare = 0.5;       ///< of |g|² that a round may leave
	double localGood = 0.2; ///< share of |g|² that a good step leaves at most, once there have been such

	// Every step.
	int halvings = 9;        ///< of a step in all three directions: a shorter one is not worth its system
	int chords = 6;          ///< steps with one factorisation, which costs as much as all of them
	double chordShare = 0.5; ///< of |g|² that a chord may leave
	int sparingRounds = 20;  ///< in which triangles that a step would spoil are made to move as one piece

	// Linear systems in the multipliers.
	int responseSteps = 3;    ///< of the power iteration for the greatest response
	int systemSteps = 200;    ///< of conjugate gradients; some tens are usual
	int slowSystem = 15;      ///< more products: the systems of this run are factorised from then on
	int slowStiffSystem = 15; ///< the same of a run that makes triangles stiffer
	int foreseenWork = 8;     ///< of rows added to one that is factorised, in steps of conjugate gradients
	double dearPreconditioner = 1e5; ///< operations a place: more than a factorised system usually takes
	double plainAbove = 0.01; ///< share of the greatest response: with such an ε no preconditioner pays
	double slackMass = 100;   ///< κ of the preconditioner

	// Triangles that would be spoilt are made stiffer.
	int stiffenings = 4;          ///< before a step
	double firstStiffness = 0.1;  ///< share of what it costs to move a corner
	double stiffnessIncrease = 4; ///< factor, each time again
	double stiffShare = 0.1;      ///< of all triangles: more are no accidents of the triangulation
	int stiffTriangles = 20;      ///< fewer are no sign of anything

	// What counts as a sound shape near the original.
	double sliverShare = 0.5;   ///< of the smallest angle of the original
	double sliverAngle = 2;     ///< degrees; angles above it are no slivers in any case
	double sliverMargin = 1.01; ///< for what rounding to the host's scalar may take away

	// Back to within the bound on displacements.
	int returnRounds = 12;
	int returnSteps = 2;             ///< in a round, towards the original
	double returnCurvature = 0.03;   ///< of the original, a share that is as dear to it as the displacement
	double returnDecrease = 0.1;     ///< of ε after a round that led no nearer
	double returnRestoration = 1e-6; ///< share of the greatest response: ε where a round's restoration begins
	double returnGain = 0.01;        ///< share of the distance: less is next to nothing
	int returnPatience = 3;          ///< rounds in a row that gain next to nothing
	double returnAim = 0.9;          ///< share of the bound: aimed at; places beyond it are at the bound
	double returnWeight = 200;       ///< of the place that was farthest so far, beside its mass
	double returnWeightTogether = 1000; ///< the same of panels that are sewn together
	double heavyPlace = 1000;           ///< of its mass, at the bound on a finer level
	double boundWeight = 300;           ///< of a place at a bound in a restoration within it, beside its mass
	double boundWeightIncrease = 2;     ///< of that from a round to the next
	double boundSharpness = 32; ///< power of the displacement's share of the bound that a place is heavier by
	double boundAim = 0.97;     ///< share of the bound: where places beyond it are pulled back to
	int boundRounds = 10;       ///< of pulling back and restoring
	double returnReach = 3;     ///< of the bound: shapes farther away are given up
	double preferredMove = 0.02; ///< share of the diagonal: less far is a bound that is kept if that is easy
	double preferredLength = 1e300; ///< length: the same, where that is less
	int returnPlaces = 7000;        ///< more: the way to within the preferred move is left to a coarser level
	int returnPlacesTogether = 20000;        ///< the same of panels that are sewn together
	double preferredPrice = 1.05;            ///< of it: the mean displacement, beside what it was
	double preferredReach = 3;               ///< of it: shapes farther away are taken as they are
	double preferredReachBeforeOthers = 1.1; ///< the same on finer levels, where other ways follow
	double preferredCurvature = 0.15; ///< of the original, a share: more of it back within the move, likewise
	double preferredWork = 6;         ///< times the rest: on ways back
	double preferredWorkPerPlace = 1000; ///< at most on a single panel, in units of WorkBudget
	int beyondPreferred = 1;             ///< 0: panels that are sewn together are given up instead
	double pullBackReach = 1.6;          ///< of a bound: from farther away places are not pulled back
	double pullBackShare = 0.7;          ///< of the displacement, at the second try
	int pullBackRounds = 4;              ///< a try, each with more heavy places
	int pullBackSteps = 200;             ///< a try
	double goOnBeyond = 0.01; ///< share of C at the start from which steps within it go on beyond it
	int leastSquares = 1;     ///< 0: where there is no way back, steps do not go on to the least squares of g
	int leastSquaresSteps = 40; ///< on this way, unless held places or the bound are what is in it

	// Developable panels that overlap themselves when they are laid flat.
	int separationSteps = 40;    ///< to move them apart; 0: they are left as they are
	double separationReach = 20; ///< of the bound: longer stretches upon the panel itself are left there
	double separationGap = 0.02; ///< of a mean edge, that is to be between borders that crossed, at most
	double separationLeastGap = 0.001; ///< of it, at least
	double separationKept = 0.1;       ///< of it: gaps that have so much more are no matter any more
	double separationEpsilon = 1e-6;   ///< share of the greatest response: ε of the first step
	double separationIdle = 0.95;      ///< share of what it lowers that is left by a step that changes little
	int separationPatience = 4;        ///< such steps in a row
	double separationWorkPerPlace = 3000; ///< at most, in units of WorkBudget

	// Panels that are sewn together and developable: closer yet, if that is easy.
	double closerFrom = 0.5;  ///< share of the preferred move: less far is near enough
	double closerReach = 1.5; ///< of it: shapes farther away are left as they are
	double closerStep = 0.9;  ///< of the largest displacement: the bound of a round
	int closerRounds = 8;
	double closerWorkPerPlace = 2000; ///< on all rounds, in units of WorkBudget

	// Panels that are sewn together and end beyond the preferred move, or are not developable.
	int otherLevels = 3;            ///< other ways that are tried then at most
	double otherLevelWork = 0.6;    ///< share of the work of a run, that each of them may take
	double workBeforeOthers = 3000; ///< a place, until another thread begins the first: many runs end before

	// How much work a part may take, in units of WorkBudget: about as much as ten times the paper's 200
	// steps.
	double workPerPlace = 6000;
	double workOnSmall = 1e6;      ///< at least
	double reserveOfCareful = 0.4; ///< share of it that is left to the free attempt
	double reserveOfCoarse = 0.2;  ///< and to a finer level
	double workTogether = 1.2;     ///< times that of more panels that are sewn together
	double workOfOthers = 0.4;     ///< share of it, once patches are frozen

	// Runs that only ask whether there is a shape near. On the way from the original to zero curvature the
	// distance grows: what has come too far is given up.
	// Never, where they are so large, however small the bound is.
	double wayFarthest = 1e300; ///< share of the bound on displacements that a place may have on the way
	double wayMean = 1e300;     ///< and all places on average

	// A start without symmetry.
	double symmetryBreaking = 1e-4; ///< share of the diagonal
	double symmetryWaves = 0.7;     ///< in a diagonal

	// The free attempt, after the careful one.
	double workBeforeNext = 300; ///< a place, until another thread begins it; most careful ones end before

	// Levels.
	int coarsest = 1500;              ///< places; so few are solved directly
	int coarsestTogether = 1000;      ///< on the coarsest level of more panels that are sewn together
	double levelRatio = 4;            ///< between the numbers of places of two levels
	double coarseRoom = 0.95;         ///< share of the bound on displacements that a coarser level has
	double leastReduction = 0.7;      ///< share of the places: else a level is not worth its while
	double fineSmoothness = 0.01;     ///< share of α on finer levels of sewn panels: not on large ones
	double prolongationBending = 0.3; ///< β in units of (A/n)²: waves below five coarse edges are left out
	double prolongationMass = 1e-6;   ///< share of its mass that a place has which the coarse level has not
	double coarseShortening = 0.1;    ///< of a border, by a place that goes at most, in coarse edges
	double coarseShare = 0.25;        ///< of the places, the smallest, that may go in a sweep
	double coarseTurn = 0.5;          ///< cosine of the angle that a triangle may turn by
	double coarseCotangent = 4;       ///< the greatest of a new triangle's angles
	int coarseFan = 9; ///< triangles round a place that goes: more leave a fan that is no better

	/// How far a place had better move, length.
	/// \param diagonal  of the part
	double preferredBound(double diagonal) const {
		return preferredLength < preferredMove * diagonal ? preferredLength : preferredMove * diagonal;
	}
	/// On finer levels, where other ways follow: back to within the preferred move no rounds go, and places
	/// are pulled back from nearly there only.
	NewtonTuning beforeOthers() const {
		NewtonTuning tuning = *this;
		tuning.preferredReach = preferredReachBeforeOthers;
		tuning.returnRounds = 0;
		return tuning;
	}
	/// Places of the coarsest level of panels that are sewn together.
	int fewestTogether() const { return coarsestTogether < coarsest ? coarsestTogether : coarsest; }
	/// So few places, or hardly more, are solved directly: a coarser level would not be worth its while.
	/// \param most  that the coarsest level may have, `coarsest` or less
	bool isCoarsest(int places, int most) const {
		return places <= most || leastReduction * places <= coarsest;
	}
};

/// A constant by its name.
struct TuningConstant {
	std::string name;
	std::variant<double NewtonTuning::*, int NewtonTuning::*> member;

	double value(const NewtonTuning& tuning) const;
	/// A whole number is rounded, and is 1 at least.
	void set(NewtonTuning& tuning, double value) const;
};

/// All of them, in the order of NewtonTuning.
const std::vector<TuningConstant>& tuningConstants();

} // namespace developable
