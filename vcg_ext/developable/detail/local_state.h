// SPDX-License-Identifier: GPL-3.0-or-later
// local_state.h: the shape during the local method: every vertex at a height δ along its original normal.
#pragma once

#include "../angle_defect.h"
#include "copy_neighbours.h"
#include "vertex_normals.h"

namespace developable::detail {

/// Positions q + δn with the angle defects that belong to them, kept up to date move by move: a move costs
/// the corners of the triangles round the vertex and the sums at the vertex and its neighbours.
class LocalState {
public:
	LocalState(const PatchAssembly& assembly, const Positions& positions)
		: assembly_(assembly), start_(positions), positions_(positions), neighbours_(assembly),
		  normals_(copyNormals(assembly, positions)), cotangents_(cornerCotangents(assembly, positions)),
		  defects_(angleDefects(assembly, positions)), heights_(Eigen::VectorXd::Zero(assembly.copyCount())),
		  detectFunction_(developable::detectFunction(defects_)) {}

	const Positions& positions() const { return positions_; }
	const Eigen::VectorXd& defects() const { return defects_; }
	double detectFunction() const { return detectFunction_; }
	double height(int copy) const { return heights_[copy]; }
	CopyRange neighbours(int copy) const { return neighbours_.of(copy); }
	bool hasNormal(int copy) const { return !normals_.col(copy).isZero(0); }

	/// T = g² of the copy and of its neighbours (Eq. 15).
	double localDetectFunction(int copy) const {
		double sum = defects_[copy] * defects_[copy];
		for (const int neighbour : neighbours_.of(copy))
			sum += defects_[neighbour] * defects_[neighbour];
		return sum;
	}

	/// T', the derivative of T when the copy moves along its normal, in closed form.
	double localDerivative(int copy) const {
		double derivative = 0;
		for (int i = assembly_.cornerStart[copy]; i < assembly_.cornerStart[copy + 1]; ++i) {
			const int triangle = assembly_.corners[i] / 3, corner = assembly_.corners[i] % 3;
			const auto copies = assembly_.triangleCopies.col(triangle);
			const Eigen::Vector3d weights(defects_[copies[0]], defects_[copies[1]], defects_[copies[2]]);
			const AngleGradients gradients(frame(triangle));
			derivative -= 2 * gradients.weighted(weights, corner).dot(normals_.col(copy));
		}
		return derivative;
	}

	/// Moves the copy, which must be the only one at its place, to a height along its normal.
	void moveTo(int copy, double height) {
		heights_[copy] = height;
		const int place = assembly_.placeOfCopy[copy];
		positions_.col(place) = start_.col(place) + height * normals_.col(copy);
		for (int i = assembly_.cornerStart[copy]; i < assembly_.cornerStart[copy + 1]; ++i)
			updateCotangents(assembly_.corners[i] / 3);
		updateDefect(copy);
		for (const int neighbour : neighbours_.of(copy))
			updateDefect(neighbour);
	}

private:
	TriangleFrame frame(int triangle) const {
		const auto places = assembly_.trianglePlaces.col(triangle);
		return {positions_.col(places[0]), positions_.col(places[1]), positions_.col(places[2])};
	}

	void updateCotangents(int triangle) { cotangents_.col(triangle) = detail::cotangents(frame(triangle)); }

	void updateDefect(int copy) {
		if (!assembly_.copyInterior[copy])
			return;
		const double before = defects_[copy];
		defects_[copy] = angleDefect(assembly_, cotangents_, copy);
		detectFunction_ += defects_[copy] * defects_[copy] - before * before;
	}

	const PatchAssembly& assembly_;
	Positions start_, positions_;
	CopyNeighbours neighbours_;
	Eigen::Matrix3Xd normals_, cotangents_;
	Eigen::VectorXd defects_, heights_;
	double detectFunction_;
};

} // namespace developable::detail
