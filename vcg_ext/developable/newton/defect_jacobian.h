// SPDX-License-Identifier: GPL-3.0-or-later
// defect_jacobian.h: how the angle defects of all inner copies change when the places move.
#pragma once

#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"

namespace developable::detail {

/// The inner copies' angle defects g, each divided by the square root of its share of the area, so that their
/// squares add up to A ∫K² dA on any tessellation (A: the area of the whole object), and their derivative J.
/// Places that are held still count as constants. Kept by place: each has one block of three numbers for
/// every copy whose angle defect depends on it.
class DefectJacobian {
public:
	/// \param placeMass  share of the whole area that each place has
	DefectJacobian(const PatchAssembly& assembly, const Eigen::VectorXd& placeMass);

	int rowCount() const { return static_cast<int>(copyOfRow_.size()); }

	/// The scaled defects, one row for each inner copy.
	Eigen::VectorXd scaled(const Eigen::VectorXd& defects) const;

	/// For massProduct.
	void setPlaceMass(const Eigen::VectorXd& placeMass) { inverseMass_ = placeMass.cwiseInverse(); }

	/// Moves on to the derivative at these positions.
	void linearize(const Positions& positions);

	/// J d.
	Eigen::VectorXd apply(const Positions& displacement) const;

	/// Jᵀ y.
	Positions applyTransposed(const Eigen::VectorXd& multipliers) const;

	/// J for displacements along one direction a place, rows x places.
	SparseMatrix along(const Positions& directions) const;

	/// The lower triangle of J M⁻¹ Jᵀ + shift, M being the places' masses; its pattern never changes.
	const SparseMatrix& massProduct(double shift);

private:
	/// Every corner and vertex of a triangle that have a block: called with 9 * triangle + 3 * corner +
	/// vertex, row and place.
	template <class Callback>
	void forEachUse(const Callback& callback) const {
		for (int t = 0; t < assembly_.triangleCount(); ++t)
			for (int corner = 0; corner < 3; ++corner)
				for (int vertex = 0; vertex < 3; ++vertex) {
					const int row = rowOfCopy_[assembly_.triangleCopies(corner, t)];
					const int place = assembly_.trianglePlaces(vertex, t);
					if (row >= 0 && !assembly_.placeFixed[place])
						callback(9 * t + 3 * corner + vertex, row, place);
				}
	}

	/// Rows are sorted within each place, so that products of blocks lie in the lower triangle.
	void findBlocks();

	void findProducts();

	/// Calls back with row and column, row ≥ column, for every pair of blocks of every place.
	template <class Callback>
	void forEachProduct(const Callback& callback) const {
		for (int place = 0; place < assembly_.placeCount(); ++place)
			for (int i = blockStart_[place]; i < blockStart_[place + 1]; ++i)
				for (int j = blockStart_[place]; j <= i; ++j)
					callback(rowOfBlock_[i], rowOfBlock_[j]);
	}

	const PatchAssembly& assembly_;
	std::vector<int> rowOfCopy_, copyOfRow_;
	Eigen::VectorXd rowScale_, inverseMass_;
	std::vector<int> blockOf_;    // per triangle, corner and vertex: its block, or -1
	std::vector<int> blockStart_; // per place
	std::vector<int> rowOfBlock_;
	Eigen::Matrix3Xd blocks_;
	SparseMatrix product_;
	std::vector<int> productEntry_; // per pair of blocks of a place, where it goes in product_
};

} // namespace developable::detail
