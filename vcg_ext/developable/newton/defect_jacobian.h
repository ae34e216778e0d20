// SPDX-License-Identifier: GPL-3.0-or-later
// defect_jacobian.h: how the angle defects of all inner copies change when the places move.
#pragma once

#include "border_limits.h"
#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"

namespace developable::detail {

/// The inner copies' angle defects g, each divided by the square root of its share of the area, so that their
/// squares add up to A ∫K² dA on any tessellation (A: the area of the whole object), and their derivative J.
/// Borders have rows, too, which are 0 with their derivatives unless a limit is exceeded: copies whose angles
/// add up to more than 2π, by which they do, and borders that turn by more than they may (see BorderTurns).
/// Places that are held still count as constants. Kept by place: each has one block of three numbers for
/// every copy whose angle defect depends on it.
class DefectJacobian {
public:
	/// \param placeMass   share of the whole area that each place has
	/// \param borderTurn  that a border may turn by more than in the original, rad
	DefectJacobian(const PatchAssembly& assembly, const Eigen::VectorXd& placeMass, double borderTurn);

	/// Whether borders may turn as they like from now on.
	void freeBorders(bool free) { bordersFree_ = free; }
	bool bordersFree() const { return bordersFree_; }

	int rowCount() const { return copyRows() + static_cast<int>(turns_.joints().size()); }

	/// What all rows have to become 0 of, scaled.
	/// \param defects  flatDefects there
	Eigen::VectorXd scaled(const Eigen::VectorXd& defects, const Positions& positions) const;

	/// What each row is scaled by, none 0.
	const Eigen::VectorXd& rowScale() const { return rowScale_; }

	/// For massProduct.
	void setPlaceMass(const Eigen::VectorXd& placeMass) { inverseMass_ = placeMass.cwiseInverse(); }

	/// Moves on to the derivative at these positions.
	void linearize(const Positions& positions);

	/// Borders that turn no more than they may at the positions of the derivative, but would at the end of a
	/// step, get their derivatives too: so a step ends at the limit. \return whether there are any new ones
	bool foresee(const Positions& positions, const Positions& end);

	/// Of borders whose limits were foreseen since the last linearize(), in the order in which they were.
	std::vector<int> foreseenRows() const;

	/// The linearised rows at the positions of the derivative: as scaled() there, but how far they are from
	/// their limits for borders that were foreseen.
	Eigen::VectorXd linearResidual(Eigen::VectorXd scaled) const;

	/// J d.
	Eigen::VectorXd apply(const Positions& displacement) const;

	/// What each row can change by at most when no place moves farther than this.
	Eigen::VectorXd greatestChange(double farthest) const;

	/// J, rows x 3 places: the coordinates of a place are neighbours.
	SparseMatrix matrix() const;

	/// Jᵀ y.
	Positions applyTransposed(const Eigen::VectorXd& multipliers) const;

	/// J for displacements along one direction a place, rows x places.
	SparseMatrix along(const Positions& directions) const;

	/// Where a copy is, or a border turns.
	int placeOfRow(int row) const {
		return row < copyRows() ? assembly_.placeOfCopy[copyOfRow_[row]]
								: turns_.joints()[row - copyRows()][1];
	}

	/// The rows in the order of their places, a turn's being the middle one.
	/// \param placeOrder  all places
	std::vector<int> rowOrder(const std::vector<int>& placeOrder) const;

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
		for (std::size_t i = 0; i < turns_.joints().size(); ++i)
			for (int end = 0; end < 3; ++end)
				if (!assembly_.placeFixed[turns_.joints()[i][end]])
					callback(useOfTurn(i, end), copyRows() + static_cast<int>(i), turns_.joints()[i][end]);
	}

	int copyRows() const { return static_cast<int>(copyOfRow_.size()); }
	int useOfTurn(int joint, int end) const { return 9 * assembly_.triangleCount() + 3 * joint + end; }
	/// Adds to the block of a use, where it has one.
	void addToBlock(int use, const Eigen::Vector3d& gradient) {
		if (blockOf_[use] >= 0)
			blocks_.col(blockOf_[use]) += gradient;
	}
	void scaleCopyRows(const Positions& positions);
	/// The derivative of a turn about an axis.
	void addTurn(int joint, const Eigen::Vector3d& axis, const Positions& positions);

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
	const BorderTurns turns_;
	bool bordersFree_ = false;
	std::vector<char> turnLimited_;                // per joint, whether it has its derivative
	std::vector<std::pair<int, double>> foreseen_; // row, and how far it is from its limit, scaled
	std::vector<int> rowOfCopy_, copyOfRow_;
	Eigen::VectorXd rowScale_, inverseMass_;
	std::vector<int> blockOf_; // per triangle, corner and vertex, then per turn and place: its block, or -1
	std::vector<int> blockStart_; // per place
	std::vector<int> rowOfBlock_;
	Eigen::Matrix3Xd blocks_;
	SparseMatrix product_;
	std::vector<int> productEntry_; // per pair of blocks of a place, where it goes in product_
};

} // namespace developable::detail
