// SPDX-License-Identifier: GPL-3.0-or-later
// held_grain.cpp: how fast a grain turns, for each way in which it is told, and turning pieces back.
#include "held_grain.h"

#include "grain_directions.h"

#include "developable/linear/linear.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace developable {

namespace {

/// How an angle changes with the vector that has it: its derivatives by that vector.
Eigen::Vector2d slopeOfAngle(const Eigen::Vector2d& vector) {
	return Eigen::Vector2d(-vector[1], vector[0]) / vector.squaredNorm();
}

/// The derivatives of the grain of one piece, added to those of all.
struct Slopes {
	Eigen::Matrix2Xd byPattern;
	Positions byShape;

	/// Of the chord from one vertex to another.
	void addChord(const Eigen::Matrix2Xd& flat, const std::array<int, 2>& side) {
		const Eigen::Vector2d slope = slopeOfAngle(flat.col(side[1]) - flat.col(side[0]));
		byPattern.col(side[1]) += slope;
		byPattern.col(side[0]) -= slope;
	}

	/// Of Σ w Fᵀa, F = X U⁻¹ with the edges X of the shape and U of the pattern: d(Fᵀa) = U⁻ᵀ (dXᵀa − dUᵀ
	/// Fᵀa).
	void addAxis(const StrainedTriangles& triangles, const Positions& shaped, const Eigen::Matrix2Xd& flat,
				 const Eigen::Vector3d& axis, double angle) {
		const Eigen::Vector2d across(-std::sin(angle), std::cos(angle));
		double length = 0;
		for (int t = 0; t < triangles.count(); ++t) {
			const TriangleStrain strain = strainOf(triangles, shaped, flat, t);
			const Eigen::Vector2d image = strain.map.transpose() * axis;
			length += triangles.weights[t] * image.dot(Eigen::Vector2d(across[1], -across[0]));
			const Eigen::Vector2d byEdges = triangles.weights[t] * strain.inverseFlatEdges * across;
			for (const int edge : {1, 2})
				for (const int end : {0, edge}) {
					const double sign = end == 0 ? -1 : 1;
					byShape.col(triangles.shaped(end, t)) += sign * byEdges[edge - 1] * axis;
					byPattern.col(triangles.flat(end, t)) -= sign * byEdges[edge - 1] * image;
				}
		}
		byShape /= length;
		byPattern /= length;
	}

	/// Of the direction in which points lie farthest apart: by the perturbation of an eigenvector.
	void addPrincipal(const StrainedTriangles& triangles, const Eigen::Matrix2Xd& flat) {
		const std::vector<int> corners(triangles.flat.reshaped().begin(), triangles.flat.reshaped().end());
		const Eigen::Matrix2Xd points = flat(Eigen::all, corners);
		const Eigen::Matrix2Xd centred = points.colwise() - points.rowwise().mean().eval();
		const SymmetricEigen eigen = symmetricEigen(centred * centred.transpose());
		const Eigen::Vector2d along = eigen.vectors.col(1), across(-along[1], along[0]);
		const double gap = eigen.values[1] - eigen.values[0];
		if (!(gap > 1e-9 * eigen.values[1]))
			return; // as long as wide: it has no direction that could be kept
		for (std::size_t i = 0; i < corners.size(); ++i) {
			const auto point = centred.col(Eigen::Index(i));
			byPattern.col(corners[i]) += (point.dot(along) * across + point.dot(across) * along) / gap;
		}
	}

private:
	static TriangleStrain strainOf(const StrainedTriangles& triangles, const Positions& shaped,
								   const Eigen::Matrix2Xd& flat, int t) {
		return {shaped(Eigen::all, triangles.shaped.col(t)), flat(Eigen::all, triangles.flat.col(t))};
	}
};

} // namespace

HeldGrain::HeldGrain(std::vector<Piece> pieces, const Grain& grain, const Positions& shaped,
					 const Eigen::Matrix2Xd& flat)
	: pieces_(std::move(pieces)), grain_(grain) {
	for (const Piece& piece : pieces_) {
		angles_.push_back(grainDirection(piece.triangles, shaped, flat, grain, piece.longestSide));
		std::vector<int> vertices(piece.triangles.flat.reshaped().begin(),
								  piece.triangles.flat.reshaped().end());
		std::sort(vertices.begin(), vertices.end());
		vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
		vertices_.push_back(std::move(vertices));
	}
}

void HeldGrain::align(const Positions& shaped, Eigen::Matrix2Xd& flat) const {
	for (std::size_t i = 0; i < pieces_.size(); ++i) {
		const double angle =
			grainDirection(pieces_[i].triangles, shaped, flat, grain_, pieces_[i].longestSide);
		const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angles_[i] - angle).toRotationMatrix();
		const Eigen::Vector2d centre = flat.col(vertices_[i].front());
		for (const int vertex : vertices_[i])
			flat.col(vertex) = centre + turn * (flat.col(vertex) - centre);
	}
}

Eigen::MatrixXd HeldGrain::slopes(const Positions& shaped, const Eigen::Matrix2Xd& flat, bool byShape) const {
	const Eigen::Index before = byShape ? shaped.size() : 0;
	Eigen::MatrixXd result(before + flat.size(), pieces_.size());
	for (std::size_t i = 0; i < pieces_.size(); ++i) {
		Slopes slopes{Eigen::Matrix2Xd::Zero(2, flat.cols()), Positions::Zero(3, shaped.cols())};
		if (!grain_.alongSeam())
			slopes.addAxis(pieces_[i].triangles, shaped, flat, grain_.direction(), angles_[i]);
		else if (pieces_[i].longestSide[0] >= 0)
			slopes.addChord(flat, pieces_[i].longestSide);
		else
			slopes.addPrincipal(pieces_[i].triangles, flat);
		result.col(Eigen::Index(i)).tail(flat.size()) = slopes.byPattern.reshaped();
		if (byShape)
			result.col(Eigen::Index(i)).head(before) = slopes.byShape.reshaped();
	}
	return result;
}

} // namespace developable
