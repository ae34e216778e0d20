// SPDX-License-Identifier: GPL-3.0-or-later
// coarsening.h: the same patches with fewer vertices, for methods that work from coarse to fine.
#pragma once

#include "developable/mesh/mesh.h"
#include "newton_tuning.h"

#include <array>

namespace developable::detail {

/// Takes places out by collapsing each into a neighbour, as independent sets (no two of one sweep are
/// neighbours; Dobkin and Kirkpatrick 1985, Lee et al. 1998), those with the smallest triangles first: what
/// is left is as fine in one place as in the other, along curves as inside patches. An inner place goes into
/// the neighbour that leaves the best triangles; a place on a seam or boundary only along it, in all its
/// patches at once, and not where the curve ends, branches or turns sharply. Places that are held still stay
/// unless all around them do.
class Coarsening {
public:
	Coarsening(const PatchAssembly& assembly, const NewtonTuning& tuning);

	/// Sweeps until so many places are left, or no more can go.
	PartialAssembly coarsen(int placesWanted);

private:
	Eigen::Vector3d placePosition(int place) const;
	Eigen::Vector3d position(int copy) const;

	/// Places inside a patch have no curve neighbours, those on a smooth curve have two.
	void findCurves();

	/// So that a curve would become much shorter without it.
	bool turnsSharply(int place) const;

	/// What each place has of the area by now, times six.
	std::vector<double> areas() const;

	void addCurveNeighbour(int place, int neighbour);

	/// \param share  of the places, those with the smallest triangles, that may go
	void sweep(int placesWanted, double share);

	/// Held places define where nothing moves: one may go only from among its like.
	bool mayGo(int place) const;

	void remove(int place);

	int cornerOfCopy(int triangle, int copy) const;

	/// The copy of a place beside this copy, or -1; `shared` becomes the number of triangles with both.
	int copyBeside(int copy, int place, int& shared) const;

	/// Copies joined to both by an edge.
	int commonNeighbours(int copy, int other) const;

	/// The largest cotangent that would be left round a place, +∞ when it can't go there.
	double worstAfter(int place, int neighbour, double limit) const;

	bool hasCopy(int triangle, int copy) const { return (triangles_.col(triangle).array() == copy).any(); }

	double cotangentAfter(int triangle, int copy, int other) const;

	void collapse(int place, int neighbour);

	int otherCurveNeighbour(int place, int neighbour) const;

	const PatchAssembly& assembly_;
	const NewtonTuning tuning_;
	Eigen::Matrix3Xi triangles_; // copies
	std::vector<char> alive_;
	int placeCount_;
	double shortening_ = 0;                       // of a curve at most, by a place that goes, length
	std::vector<std::vector<int>> fans_, copies_; // triangles of a copy, copies of a place
	std::vector<std::array<int, 2>> curveNeighbours_;
	std::vector<char> corner_, removed_, locked_;
};

} // namespace developable::detail
