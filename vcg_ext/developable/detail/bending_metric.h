// SPDX-License-Identifier: GPL-3.0-or-later
// bending_metric.h: how long a displacement is: how far it moves the surface, and how much it bends.
#pragma once

#include "../angle_defect.h"
#include "../exceptions.h"
#include "sparse_cholesky.h"

namespace developable::detail {

/// The metric ‖d‖² = (Σ_q m_q |d_q|² + Σ_e α A_p² |K_e d|² / (A_1 + A_2)) / A on displacements d of the
/// places: m_q is a third of the area round a place, e a hinge (an inner edge of a patch with its two
/// triangles of area A_1 and A_2), K_e d the jump across it of the displacement's slope times its length
/// (Bergou et al. 2006, A Quadratic Bending Model for Inextensible Surfaces, Section 3), A_p the patch's area
/// and A that of all patches. The second sum tends to α A_p² ∫|d''|², so α is a number without unit and means
/// the same on a model of any size and tessellation. Folding along a seam costs nothing. Places that are held
/// still have no displacement: their rows are those of a diagonal matrix.
class BendingMetric {
public:
	/// \param smoothness  α, per patch
	BendingMetric(const PatchAssembly& assembly, const Eigen::VectorXd& smoothness)
		: placeMass_(Eigen::VectorXd::Zero(assembly.placeCount())) {
		const Eigen::VectorXd areas = triangleAreas(assembly);
		const double area = areas.sum();
		for (int t = 0; t < assembly.triangleCount(); ++t)
			for (const int place : assembly.trianglePlaces.col(t))
				placeMass_[place] += areas[t] / (3 * area);
		std::vector<Eigen::Triplet<double>> entries;
		entries.reserve(assembly.placeCount() + 10 * assembly.edgeCount());
		for (int place = 0; place < assembly.placeCount(); ++place)
			entries.emplace_back(place, place, placeMass_[place]);
		addHinges(assembly, areas, smoothness, entries);
		lower_.resize(assembly.placeCount(), assembly.placeCount());
		lower_.setFromTriplets(entries.begin(), entries.end());
		if (!factorization_.factorize(lower_))
			throw DegenerateTriangle(
				"Some faces are too thin to compute with: remove needle-like faces first.");
	}

	/// m_q, the share that each place has of the whole area.
	const Eigen::VectorXd& placeMass() const { return placeMass_; }

	/// W d.
	Positions apply(const Positions& displacement) const {
		return (lower_.selfadjointView<Eigen::Lower>() * displacement.transpose()).transpose();
	}

	/// W⁻¹ f; f must be zero at places that are held still.
	Positions solve(const Positions& force) const {
		return factorization_.solve(Eigen::MatrixXd(force.transpose())).transpose();
	}

	double squaredNorm(const Positions& displacement) const {
		return displacement.cwiseProduct(apply(displacement)).sum();
	}

private:
	static Eigen::VectorXd triangleAreas(const PatchAssembly& assembly) {
		Eigen::VectorXd areas(assembly.triangleCount());
		const Positions& positions = assembly.originalPositions;
		for (int t = 0; t < assembly.triangleCount(); ++t) {
			const auto places = assembly.trianglePlaces.col(t);
			areas[t] =
				TriangleFrame(positions.col(places[0]), positions.col(places[1]), positions.col(places[2]))
					.normal.norm() /
				2;
		}
		return areas;
	}

	static void addHinges(const PatchAssembly& assembly, const Eigen::VectorXd& areas,
						  const Eigen::VectorXd& smoothness, std::vector<Eigen::Triplet<double>>& entries) {
		const Eigen::Matrix3Xd cotangents = cornerCotangents(assembly, assembly.originalPositions);
		Eigen::VectorXd patchArea = Eigen::VectorXd::Zero(assembly.patchCount());
		for (int t = 0; t < assembly.triangleCount(); ++t)
			patchArea[assembly.patchOfTriangle[t]] += areas[t];
		for (const int halfEdge : assembly.edgeHalfEdge) {
			const int across = assembly.joinedHalfEdge[halfEdge];
			if (across < 0)
				continue;
			const int patch = assembly.patchOfTriangle[halfEdge / 3];
			const double weight = smoothness[patch] * patchArea[patch] * patchArea[patch] /
								  (areas.sum() * (areas[halfEdge / 3] + areas[across / 3]));
			addHinge(assembly, cotangents, halfEdge, across, weight, entries);
		}
	}

	static void addHinge(const PatchAssembly& assembly, const Eigen::Matrix3Xd& cotangents, int halfEdge,
						 int across, double weight, std::vector<Eigen::Triplet<double>>& entries) {
		// Of each of the two triangles: the corners at the edge's ends, then the one opposite to it.
		int places[2][3];
		double cotangent[2][2];
		for (int side = 0; side < 2; ++side) {
			const int triangle = (side ? across : halfEdge) / 3, first = (side ? across : halfEdge) % 3;
			for (int i = 0; i < 3; ++i)
				places[side][i] = assembly.trianglePlaces((first + i) % 3, triangle);
			for (int i = 0; i < 2; ++i)
				cotangent[side][i] = cotangents((first + i) % 3, triangle);
		}
		const int same = places[0][0] == places[1][0] ? 0 : 1; // the second's corner at the first's first end
		const int place[4] = {places[0][0], places[0][1], places[0][2], places[1][2]};
		const double slope[4] = {cotangent[0][1] + cotangent[1][1 - same],
								 cotangent[0][0] + cotangent[1][same], -cotangent[0][0] - cotangent[0][1],
								 -cotangent[1][0] - cotangent[1][1]};
		for (int i = 0; i < 4; ++i)
			for (int j = 0; j < 4; ++j)
				if (place[i] >= place[j] && !assembly.placeFixed[place[i]] && !assembly.placeFixed[place[j]])
					entries.emplace_back(place[i], place[j], weight * slope[i] * slope[j]);
	}

	Eigen::VectorXd placeMass_;
	SparseMatrix lower_;
	SparseCholesky factorization_;
};

} // namespace developable::detail
