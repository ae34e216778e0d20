// SPDX-License-Identifier: GPL-3.0-or-later
// report.h: what an optimisation says about its run.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace developable {

/// Why a run ended. The numbers are part of the interface.
enum class Status {
	Converged =
		0, ///< every vertex copy is a developable point (and C is below its tolerance, where one is set)
	Stalled = 1,      ///< further steps would change nothing worth having
	LimitReached = 2, ///< the limit of iterations or operations
	NeedsCut = 3,     ///< there is no developable shape near this one: it needs a cut
	Stopped = 4,      ///< the user asked for a stop; nothing was changed
	NothingToDo = 5   ///< developable from the start
};

struct StatusProperties {
	Status status;
	const char* name; ///< in scripts
	const char* text;
};

/// Of all statuses, in the order of Status.
inline constexpr StatusProperties statusProperties[] = {
	{Status::Converged, "CONVERGED", "converged"},
	{Status::Stalled, "STALLED", "stalled: further steps would change next to nothing"},
	{Status::LimitReached, "LIMIT_REACHED", "stopped at the limit of iterations or operations"},
	{Status::NeedsCut, "NEEDS_CUT", "no developable shape near this one: it needs a cut"},
	{Status::Stopped, "STOPPED", "stopped by the user: nothing was changed"},
	{Status::NothingToDo, "NOTHING_TO_DO", "nothing to do: developable from the start"},
};

/// The status in a few words.
inline std::string describe(Status status) {
	return statusProperties[static_cast<int>(status)].text;
}

/// What there is to say of a status beyond its own words. The numbers are part of the interface.
enum class Reason {
	AsStatus = 0,       ///< nothing
	NotLowered = 1,     ///< the local method stalled: G has not fallen for long
	NothingMoves = 2,   ///< the local method stalled: no vertex can move
	NeedsCut = 3,       ///< so many patches need a cut, and where
	Unsolvable = 4,     ///< the constrained Newton method stalled at a system without a solution in double
	TooFar = 5,         ///< a developable shape was found, but farther away than places may go
	NearlyThere = 6,    ///< a cut is needed, but what is left is small
	BeyondBounds = 7,   ///< so many patches have no pattern within their material's bounds, and where
	WithinBounds = 8,   ///< every patch has a pattern within its material's bounds
	BorderOverlaps = 9, ///< the curvature is gone, but the angles at border vertices exceed a full turn
	// Of a panel that was cut and holds, why it has its longest seam, slit or dart: without that
	SeamTooFar = 10,       ///< a vertex would have to move too far
	SeamOverlaps = 11,     ///< it would overlap itself when laid flat
	SeamNoSheet = 12,      ///< it would be a ring, a tube or a ball
	SeamBeyondBounds = 13, ///< it would be strained by more than the material bears
	SeamSewn = 14,         ///< it would hold by itself, but not among the others
	SeamStill = 15,        ///< it would have to move; with it nothing has to
	SeamCrumples = 16      ///< it would become developable only by folds all over
};

struct ReasonProperties {
	Reason reason;
	const char* name; ///< in scripts
	/// In place of the status's text; {names} stand for numbers with these names in the filters' results.
	const char* text;
};

/// Of all reasons, in the order of Reason.
inline constexpr ReasonProperties reasonProperties[] = {
	{Reason::AsStatus, "AS_STATUS", ""},
	{Reason::NotLowered, "NOT_LOWERED",
	 "stalled: the last 20 operations a movable vertex have not lowered G"},
	{Reason::NothingMoves, "NOTHING_MOVES", "stalled: within the tolerance nothing can move any more"},
	{Reason::NeedsCut, "NEEDS_CUT",
	 "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, "
	 "first of all at ({worst_x}, {worst_y}, {worst_z}); next, cut it: 'developable cut' on the command line, "
	 "the filter Cut into Developable Panels in MeshLab"},
	{Reason::Unsolvable, "UNSOLVABLE",
	 "stalled: a linear system of this shape has no solution in double precision; the best shape so far is kept"},
	{Reason::TooFar, "TOO_FAR",
	 "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, "
	 "first of all at ({worst_x}, {worst_y}, {worst_z}); the nearest developable one found moves a vertex by "
	 "{nearest_developable}, farther than max_displacement allows"},
	{Reason::NearlyThere, "NEARLY_THERE",
	 "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, "
	 "first of all at ({worst_x}, {worst_y}, {worst_z}); but it is nearly there: laid flat as it is, no edge "
	 "changes its length by more than {edge_strain_left} %"},
	{Reason::BeyondBounds, "BEYOND_BOUNDS",
	 "no shape near this one has a pattern within the allowed strain: it needs a cut in {patches_needing_cut} of {patches} "
	 "patches, first of all at ({worst_x}, {worst_y}, {worst_z})"},
	{Reason::WithinBounds, "WITHIN_BOUNDS", "every panel has a pattern within the allowed strain"},
	{Reason::BorderOverlaps, "BORDER_OVERLAPS",
	 "the curvature is gone, but the angles of a panel's faces add up to more than a full turn at border vertices "
	 "({border_overlaps} in number), first of all at ({worst_x}, {worst_y}, {worst_z}): laid flat it overlaps itself there; a cut "
	 "that ends there would do, or more room to move (max_displacement, fewer vertices held still)"},
	{Reason::SeamTooFar, "SEAM_TOO_FAR",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it a vertex would have to "
	 "move farther than max_displacement allows"},
	{Reason::SeamOverlaps, "SEAM_OVERLAPS",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would overlap "
	 "itself when laid flat"},
	{Reason::SeamNoSheet, "SEAM_NO_SHEET",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would close "
	 "round on itself, as a ring, a tube or a ball, and not be one sheet"},
	{Reason::SeamBeyondBounds, "SEAM_BEYOND_BOUNDS",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would be "
	 "strained by more than the material bears"},
	{Reason::SeamSewn, "SEAM_SEWN",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), was found to help: without it the panel would "
	 "do by itself, but hardly with smooth seams and sewn to the others"},
	{Reason::SeamStill, "SEAM_STILL",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), spares all movement: without it the panel would "
	 "do, but not as it is"},
	{Reason::SeamCrumples, "SEAM_CRUMPLES",
	 "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would crumple"},
};

/// What follows a reason's text where {edge_strain_left} is known and the text has not said it.
inline constexpr const char* strainLeftText =
	"; laid flat as it is, no edge changes its length by more than {edge_strain_left} %";

/// How one patch ended.
struct PatchVerdict {
	Status status = Status::NothingToDo;
	Reason reason = Reason::AsStatus;
	double nearestDevelopable = 0; ///< see OptimizationReport
	int borderOverlaps = 0;        ///< alike
};

/// What every optimisation reports. Shapes are compared by the caller, which has both of them.
struct OptimizationReport {
	Status status = Status::NothingToDo;
	Reason reason = Reason::AsStatus;
	long iterations = 0; ///< outer steps of the global methods, operations attempted of the local method
	int patchesNeedingCut = 0;
	std::array<double, 3> worstPosition = {}; ///< where a cut is needed first of all; 0 where none is
	/// How far the nearest developable shape that was found moves a place, where that is too far: length; 0
	/// where none was found, or none too far.
	double nearestDevelopable = 0;
	/// Border vertices at which the angles of a patch exceed a full turn though its curvature is gone.
	int borderOverlaps = 0;
	std::vector<PatchVerdict> patchVerdicts; ///< empty where the method does not tell patches apart
};

/// True when the run ended in a developable shape, as that method's tolerances have it.
inline bool converged(Status status) {
	return status == Status::Converged || status == Status::NothingToDo;
}

} // namespace developable
