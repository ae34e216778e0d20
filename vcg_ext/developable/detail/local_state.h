// SPDX-License-Identifier: GPL-3.0-or-later
// local_state.h: the shape during the local method: every place at a height δ along its original normal.
#pragma once

#include "../angle_defect.h"
#include "movers.h"

namespace developable::detail {

/// Positions q + δn with the angle defects that belong to them, kept up to date move by move: a move costs
/// the corners of the triangles round the place and the sums at its copies and their neighbours.
class LocalState {
public:
	LocalState(const PatchAssembly& assembly, const Positions& positions, const Movers& movers)
		: assembly_(assembly), movers_(movers), start_(positions), positions_(positions),
		  cotangents_(cornerCotangents(assembly, positions)), defects_(angleDefects(assembly, positions)),
		  heights_(Eigen::VectorXd::Zero(assembly.placeCount())),
		  detectFunction_(developable::detectFunction(defects_)) {}

	const Positions& positions() const { return positions_; }
	const Eigen::VectorXd& defects() const { return defects_; }
	double detectFunction() const { return detectFunction_; }
	double height(int place) const { return heights_[place]; }

	/// T = Σ g² over the copies at the place and their neighbours (Eq. 15).
	double localDetectFunction(int place) const {
		double sum = 0;
		for (const int copy : movers_.affected.of(place))
			sum += defects_[copy] * defects_[copy];
		return sum;
	}

	double largestSquaredDefect(int place) const {
		double largest = 0;
		for (const int copy : movers_.affected.of(place))
			largest = std::max(largest, defects_[copy] * defects_[copy]);
		return largest;
	}

	/// T', the derivative of T when the place moves along its normal, in closed form.
	double localDerivative(int place) const {
		double derivative = 0;
		for (const int index : movers_.corners.of(place)) {
			const int triangle = index / 3, corner = index % 3;
			const auto copies = assembly_.triangleCopies.col(triangle);
			const Eigen::Vector3d weights(defects_[copies[0]], defects_[copies[1]], defects_[copies[2]]);
			const AngleGradients gradients(frame(triangle));
			derivative -= 2 * gradients.weighted(weights, corner).dot(movers_.normals.col(place));
		}
		return derivative;
	}

	/// The mean square difference between the place's height and its neighbours', measured along its normal;
	/// length².
	double unevenness(int place) const {
		double sum = 0;
		for (const int copy : neighbours(place))
			sum += std::pow(heights_[place] - heightAlong(place, copy), 2);
		return sum / neighbours(place).size();
	}

	/// Its derivative when the place moves along its normal, length.
	double unevennessDerivative(int place) const {
		double sum = 0;
		for (const int copy : neighbours(place))
			sum += 2 * (heights_[place] - heightAlong(place, copy));
		return sum / neighbours(place).size();
	}

	/// Moves a place to a height along its normal.
	void moveTo(int place, double height) {
		heights_[place] = height;
		positions_.col(place) = start_.col(place) + height * movers_.normals.col(place);
		for (const int corner : movers_.corners.of(place))
			cotangents_.col(corner / 3) = cotangents(frame(corner / 3));
		for (const int copy : movers_.affected.of(place))
			updateDefect(copy);
	}

private:
	ListRange neighbours(int place) const {
		const ListRange copies = movers_.affected.of(place);
		return {copies.first + movers_.own[place], copies.last};
	}

	double heightAlong(int place, int copy) const {
		const int neighbour = assembly_.placeOfCopy[copy];
		return heights_[neighbour] * movers_.normals.col(neighbour).dot(movers_.normals.col(place));
	}

	TriangleFrame frame(int triangle) const {
		const auto places = assembly_.trianglePlaces.col(triangle);
		return {positions_.col(places[0]), positions_.col(places[1]), positions_.col(places[2])};
	}

	void updateDefect(int copy) {
		if (!assembly_.copyInterior[copy])
			return;
		const double before = defects_[copy];
		defects_[copy] = angleDefect(assembly_, cotangents_, copy);
		detectFunction_ += defects_[copy] * defects_[copy] - before * before;
	}

	const PatchAssembly& assembly_;
	const Movers& movers_;
	Positions start_, positions_;
	Eigen::Matrix3Xd cotangents_;
	Eigen::VectorXd defects_, heights_;
	double detectFunction_;
};

} // namespace developable::detail
