// SPDX-License-Identifier: GPL-3.0-or-later
// defect_jacobian.h: how the angle defects of all inner copies change when the places move.
#pragma once

#include "../angle_defect.h"
#include "sparse_cholesky.h"

#include <numeric>
#include <utility>

namespace developable::detail {

/// The inner copies' angle defects g, each divided by the square root of its share of the area, so that their
/// squares add up to A ∫K² dA on any tessellation (A: the area of the whole object), and their derivative J.
/// Places that are held still count as constants. Kept by place: each has one block of three numbers for
/// every copy whose angle defect depends on it.
class DefectJacobian {
public:
	/// \param placeMass  share of the whole area that each place has
	DefectJacobian(const PatchAssembly& assembly, const Eigen::VectorXd& placeMass)
		: assembly_(assembly), rowOfCopy_(assembly.copyCount(), -1) {
		const Eigen::VectorXd areas = copyAreas(assembly, assembly.originalPositions);
		const double area = areas.sum();
		for (int copy = 0; copy < assembly.copyCount(); ++copy)
			if (assembly.copyInterior[copy]) {
				rowOfCopy_[copy] = static_cast<int>(copyOfRow_.size());
				copyOfRow_.push_back(copy);
			}
		rowScale_.resize(rowCount());
		for (int row = 0; row < rowCount(); ++row)
			rowScale_[row] = std::sqrt(area / areas[copyOfRow_[row]]);
		inverseMass_ = placeMass.cwiseInverse();
		findBlocks();
	}

	int rowCount() const { return static_cast<int>(copyOfRow_.size()); }

	/// The scaled defects, one row for each inner copy.
	Eigen::VectorXd scaled(const Eigen::VectorXd& defects) const {
		return defects(copyOfRow_).cwiseProduct(rowScale_);
	}

	/// Moves on to the derivative at these positions.
	void linearize(const Positions& positions) {
		blocks_.setZero();
		for (int t = 0; t < assembly_.triangleCount(); ++t) {
			const auto places = assembly_.trianglePlaces.col(t);
			const AngleGradients angles(
				TriangleFrame(positions.col(places[0]), positions.col(places[1]), positions.col(places[2])));
			for (int corner = 0; corner < 3; ++corner)
				for (int vertex = 0; vertex < 3; ++vertex) {
					const int block = blockOf_[9 * t + 3 * corner + vertex];
					if (block >= 0)
						blocks_.col(block) -= angles.of(corner, vertex);
				}
		}
		for (int block = 0; block < blocks_.cols(); ++block)
			blocks_.col(block) *= rowScale_[rowOfBlock_[block]];
	}

	/// J d.
	Eigen::VectorXd apply(const Positions& displacement) const {
		Eigen::VectorXd result = Eigen::VectorXd::Zero(rowCount());
		for (int place = 0; place < assembly_.placeCount(); ++place)
			for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
				result[rowOfBlock_[block]] += blocks_.col(block).dot(displacement.col(place));
		return result;
	}

	/// Jᵀ y.
	Positions applyTransposed(const Eigen::VectorXd& multipliers) const {
		Positions result = Positions::Zero(3, assembly_.placeCount());
		for (int place = 0; place < assembly_.placeCount(); ++place)
			for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
				result.col(place) += multipliers[rowOfBlock_[block]] * blocks_.col(block);
		return result;
	}

	/// J for displacements along one direction a place, rows x places.
	SparseMatrix along(const Positions& directions) const {
		std::vector<double> values(rowOfBlock_.size());
		for (int place = 0; place < assembly_.placeCount(); ++place)
			for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
				values[block] = blocks_.col(block).dot(directions.col(place));
		return Eigen::Map<const SparseMatrix>(rowCount(), assembly_.placeCount(), values.size(),
											  blockStart_.data(), rowOfBlock_.data(), values.data());
	}

	/// The lower triangle of J M⁻¹ Jᵀ + shift, M being the places' masses; its pattern never changes.
	const SparseMatrix& massProduct(double shift) {
		if (productEntry_.empty())
			findProducts();
		Eigen::Map<Eigen::VectorXd> values(product_.valuePtr(), product_.nonZeros());
		values.setZero();
		std::size_t next = 0;
		for (int place = 0; place < assembly_.placeCount(); ++place)
			for (int i = blockStart_[place]; i < blockStart_[place + 1]; ++i)
				for (int j = blockStart_[place]; j <= i; ++j)
					values[productEntry_[next++]] += inverseMass_[place] * blocks_.col(i).dot(blocks_.col(j));
		for (int row = 0; row < rowCount(); ++row)
			values[product_.outerIndexPtr()[row]] += shift;
		return product_;
	}

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
	void findBlocks() {
		std::vector<int> useStart(assembly_.placeCount() + 1, 0);
		forEachUse([&](int, int, int place) { ++useStart[place + 1]; });
		std::partial_sum(useStart.begin(), useStart.end(), useStart.begin());
		std::vector<std::pair<int, int>> uses(useStart.back()); // row, 9 * triangle + 3 * corner + vertex
		std::vector<int> next(useStart.begin(), useStart.end() - 1);
		forEachUse([&](int use, int row, int place) { uses[next[place]++] = {row, use}; });
		blockOf_.assign(9 * static_cast<std::size_t>(assembly_.triangleCount()), -1);
		blockStart_.assign(1, 0);
		rowOfBlock_.reserve(uses.size() / 2);
		for (int place = 0; place < assembly_.placeCount(); ++place) {
			std::sort(uses.begin() + useStart[place], uses.begin() + useStart[place + 1]);
			for (int i = useStart[place]; i < useStart[place + 1]; ++i) {
				if (i == useStart[place] || uses[i].first != uses[i - 1].first)
					rowOfBlock_.push_back(uses[i].first);
				blockOf_[uses[i].second] = static_cast<int>(rowOfBlock_.size()) - 1;
			}
			blockStart_.push_back(static_cast<int>(rowOfBlock_.size()));
		}
		blocks_.resize(3, rowOfBlock_.size());
	}

	void findProducts() {
		std::vector<Eigen::Triplet<double>> entries;
		entries.reserve(rowCount());
		for (int row = 0; row < rowCount(); ++row)
			entries.emplace_back(row, row, 0);
		forEachProduct([&](int row, int column) { entries.emplace_back(row, column, 0); });
		product_.resize(rowCount(), rowCount());
		product_.setFromTriplets(entries.begin(), entries.end());
		productEntry_.reserve(entries.size());
		forEachProduct([&](int row, int column) {
			const int* rows = product_.innerIndexPtr();
			const int *begin = rows + product_.outerIndexPtr()[column],
					  *end = rows + product_.outerIndexPtr()[column + 1];
			productEntry_.push_back(static_cast<int>(std::lower_bound(begin, end, row) - rows));
		});
	}

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
