// SPDX-License-Identifier: GPL-3.0-or-later
// soundness.cpp: spoilt triangles, and moves that spare them.
#include "soundness.h"

#include "developable/geometry/geometry.h"

namespace developable::detail {

namespace {

constexpr double flipCosine = -0.5; ///< of the angle between neighbours' normals beyond which one is flipped

} // namespace

Soundness::Soundness(const PatchAssembly& assembly, const NewtonTuning& tuning)
	: assembly_(assembly), sparingRounds_(tuning.sparingRounds) {
	const double greatest = cornerCotangents(assembly, assembly.originalPositions).maxCoeff();
	const double leastAngle =
		std::min(std::atan2(1.0, greatest) * tuning.sliverShare, tuning.sliverAngle * pi / 180);
	greatestCotangent_ = 1 / std::tan(leastAngle * tuning.sliverMargin);
	const Eigen::Matrix3Xd normals = unitNormals(assembly, assembly.originalPositions);
	for (const int halfEdge : assembly.edgeHalfEdge) {
		const int across = assembly.across(halfEdge);
		if (across < 0)
			continue;
		const Hinge hinge{triangleOf(halfEdge), triangleOf(across),
						  assembly.copyAt(halfEdge) == assembly.copyAt(across) ? -1.0 : 1.0};
		if (hinge.sameSide * normals.col(hinge.first).dot(normals.col(hinge.second)) > 0)
			hinges_.push_back(hinge);
	}
}

/// What of a shape is spoilt, while some of its places move on.
class Soundness::Inspection {
public:
	Inspection(const Soundness& soundness, const Positions& positions)
		: soundness_(soundness), assembly_(soundness.assembly_), normals_(unitNormals(assembly_, positions)),
		  sliver_(assembly_.triangleCount()), flipped_(soundness.hinges_.size()) {
		const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly_, positions);
		for (int t = 0; t < assembly_.triangleCount(); ++t)
			sliver_[t] = soundness_.isSliver(cotangents.col(t));
		for (std::size_t i = 0; i < flipped_.size(); ++i)
			flipped_[i] = soundness_.isFlipped(soundness_.hinges_[i], normals_);
	}

	/// \param moved  per place, whether it was somewhere else before
	void goOn(const Positions& positions, const std::vector<char>& moved) {
		std::vector<char> changed(assembly_.triangleCount(), 0);
		for (int t = 0; t < assembly_.triangleCount(); ++t) {
			const auto places = assembly_.trianglePlaces.col(t);
			changed[t] = moved[places[0]] || moved[places[1]] || moved[places[2]];
			if (!changed[t])
				continue;
			const TriangleFrame frame = triangleFrame(positions, places);
			sliver_[t] = soundness_.isSliver(cotangents(frame));
			normals_.col(t) = frame.normal.normalized();
		}
		for (std::size_t i = 0; i < flipped_.size(); ++i) {
			const Hinge& hinge = soundness_.hinges_[i];
			if (changed[hinge.first] || changed[hinge.second])
				flipped_[i] = soundness_.isFlipped(hinge, normals_);
		}
	}

	std::vector<int> spoiltTriangles() const {
		std::vector<int> spoilt;
		for (int t = 0; t < assembly_.triangleCount(); ++t)
			if (sliver_[t])
				spoilt.push_back(t);
		for (std::size_t i = 0; i < flipped_.size(); ++i)
			if (flipped_[i])
				spoilt.insert(spoilt.end(), {soundness_.hinges_[i].first, soundness_.hinges_[i].second});
		return spoilt;
	}

private:
	const Soundness& soundness_;
	const PatchAssembly& assembly_;
	Eigen::Matrix3Xd normals_;
	std::vector<char> sliver_, flipped_; ///< per triangle, per hinge
};

bool Soundness::isSliver(const Eigen::Vector3d& cotangents) const {
	return !(cotangents[0] <= greatestCotangent_ && cotangents[1] <= greatestCotangent_ &&
			 cotangents[2] <= greatestCotangent_);
}

bool Soundness::isFlipped(const Hinge& hinge, const Eigen::Matrix3Xd& normals) {
	return !(hinge.sameSide * normals.col(hinge.first).dot(normals.col(hinge.second)) >= flipCosine);
}

std::vector<int> Soundness::spoiltTriangles(const Positions& positions) const {
	return Inspection(*this, positions).spoiltTriangles();
}

bool Soundness::spare(const Positions& from, Positions& move) const {
	Positions positions = from + move;
	Inspection inspection(*this, positions);
	for (int round = 0; round < sparingRounds_; ++round) {
		const std::vector<int> spoilt = inspection.spoiltTriangles();
		if (spoilt.empty())
			return true;
		std::vector<char> moved(assembly_.placeCount(), 0);
		for (const int triangle : spoilt) {
			const auto places = assembly_.trianglePlaces.col(triangle);
			moveAsOne(places, move);
			for (const int place : places) {
				moved[place] = 1;
				positions.col(place) = from.col(place) + move.col(place);
			}
		}
		inspection.goOn(positions, moved);
	}
	return false;
}

void Soundness::moveAsOne(const Eigen::Vector3i& places, Positions& move) const {
	const Eigen::Vector3d mean = (move.col(places[0]) + move.col(places[1]) + move.col(places[2])) / 3;
	for (const int place : places)
		if (!assembly_.placeFixed[place])
			move.col(place) = mean;
}

} // namespace developable::detail
