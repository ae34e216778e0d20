// SPDX-License-Identifier: GPL-3.0-or-later
// defect_jacobian.cpp: the derivative of all angle defects, by place.
#include "defect_jacobian.h"

#include "developable/geometry/geometry.h"

#include <algorithm>
#include <utility>

namespace developable::detail {

DefectJacobian::DefectJacobian(const PatchAssembly& assembly, const Eigen::VectorXd& placeMass,
							   double borderTurn)
	: assembly_(assembly), turns_(assembly, borderTurn), rowOfCopy_(assembly.copyCount(), -1) {
	std::vector<char> hasRow = assembly.copyInterior;
	for (const int copy : copiesThatMayOverlap(assembly))
		hasRow[copy] = 1;
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (hasRow[copy]) {
			rowOfCopy_[copy] = static_cast<int>(copyOfRow_.size());
			copyOfRow_.push_back(copy);
		}
	const Eigen::VectorXd areas = copyAreas(assembly, assembly.originalPositions);
	const double wholeArea = areas.sum();
	rowScale_.resize(rowCount());
	for (int row = 0; row < copyRows(); ++row)
		rowScale_[row] = std::sqrt(wholeArea / areas[copyOfRow_[row]]);
	for (int row = copyRows(); row < rowCount(); ++row)
		rowScale_[row] = 1 / std::sqrt(placeMass[turns_.joints()[row - copyRows()][1]]);
	setPlaceMass(placeMass);
	findBlocks();
}

Eigen::VectorXd DefectJacobian::scaled(const Eigen::VectorXd& defects, const Positions& positions) const {
	Eigen::VectorXd result(rowCount());
	result.head(copyRows()) = defects(copyOfRow_);
	if (bordersFree_)
		result.tail(rowCount() - copyRows()).setZero();
	else
		result.tail(rowCount() - copyRows()) = -turns_.excess(positions);
	return result.cwiseProduct(rowScale_);
}

void DefectJacobian::linearize(const Positions& positions) {
	blocks_.setZero();
	for (int t = 0; t < assembly_.triangleCount(); ++t) {
		const AngleGradients angles(triangleFrame(positions, assembly_.trianglePlaces.col(t)));
		for (int corner = 0; corner < 3; ++corner)
			for (int vertex = 0; vertex < 3; ++vertex)
				addToBlock(9 * t + 3 * corner + vertex, -angles.of(corner, vertex));
	}
	scaleCopyRows(positions);
	foreseen_.clear();
	turnLimited_.assign(turns_.joints().size(), 0);
	if (bordersFree_)
		return;
	const Eigen::VectorXd excess = turns_.excess(positions);
	for (int joint = 0; joint < excess.size(); ++joint)
		if (excess[joint] > 0)
			addTurn(joint, turns_.axis(joint, positions), positions);
}

bool DefectJacobian::foresee(const Positions& positions, const Positions& end) {
	const std::size_t before = foreseen_.size();
	if (bordersFree_)
		return false;
	const Eigen::VectorXd excess = turns_.excess(end);
	for (int joint = 0; joint < excess.size(); ++joint) {
		if (turnLimited_[joint] || excess[joint] <= 0)
			continue;
		const Eigen::Vector3d axis = turns_.axis(joint, end);
		const int row = copyRows() + joint;
		foreseen_.emplace_back(row, -rowScale_[row] * turns_.excessAbout(axis, joint, positions));
		addTurn(joint, axis, positions);
	}
	return foreseen_.size() > before;
}

std::vector<int> DefectJacobian::foreseenRows() const {
	std::vector<int> rows;
	for (const auto& [row, residual] : foreseen_)
		rows.push_back(row);
	return rows;
}

Eigen::VectorXd DefectJacobian::linearResidual(Eigen::VectorXd scaled) const {
	for (const auto& [row, residual] : foreseen_)
		scaled[row] = residual;
	return scaled;
}

void DefectJacobian::addTurn(int joint, const Eigen::Vector3d& axis, const Positions& positions) {
	turnLimited_[joint] = 1;
	const Eigen::Matrix3d gradient = turns_.gradientAbout(axis, joint, positions);
	for (int end = 0; end < 3; ++end)
		addToBlock(useOfTurn(joint, end), -rowScale_[copyRows() + joint] * gradient.col(end));
}

/// Copies on the boundary whose angles add up to no more than 2π have no derivative.
void DefectJacobian::scaleCopyRows(const Positions& positions) {
	Eigen::VectorXd factors = rowScale_;
	const Eigen::VectorXd angles = borderAngles(assembly_, positions);
	for (int row = 0; row < copyRows(); ++row)
		if (!assembly_.copyInterior[copyOfRow_[row]] && angles[copyOfRow_[row]] <= 2 * pi)
			factors[row] = 0;
	for (int block = 0; block < blocks_.cols(); ++block)
		blocks_.col(block) *= factors[rowOfBlock_[block]];
}

Eigen::VectorXd DefectJacobian::apply(const Positions& displacement) const {
	Eigen::VectorXd result = Eigen::VectorXd::Zero(rowCount());
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		const Eigen::Vector3d move = displacement.col(place);
		for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
			result[rowOfBlock_[block]] += blocks_.col(block).dot(move);
	}
	return result;
}

Eigen::VectorXd DefectJacobian::greatestChange(double farthest) const {
	Eigen::VectorXd change = Eigen::VectorXd::Zero(rowCount());
	for (int block = 0; block < blocks_.cols(); ++block)
		change[rowOfBlock_[block]] += farthest * blocks_.col(block).norm();
	return change;
}

Positions DefectJacobian::applyTransposed(const Eigen::VectorXd& multipliers) const {
	Positions result(3, assembly_.placeCount());
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		Eigen::Vector3d sum = Eigen::Vector3d::Zero();
		for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
			sum += multipliers[rowOfBlock_[block]] * blocks_.col(block);
		result.col(place) = sum;
	}
	return result;
}

SparseMatrix DefectJacobian::matrix() const {
	std::vector<int> start(1, 0), rows;
	std::vector<double> values;
	rows.reserve(3 * rowOfBlock_.size());
	values.reserve(3 * rowOfBlock_.size());
	for (int place = 0; place < assembly_.placeCount(); ++place)
		for (int coordinate = 0; coordinate < 3; ++coordinate) {
			for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block) {
				rows.push_back(rowOfBlock_[block]);
				values.push_back(blocks_(coordinate, block));
			}
			start.push_back(static_cast<int>(rows.size()));
		}
	return Eigen::Map<const SparseMatrix>(rowCount(), 3 * assembly_.placeCount(), values.size(), start.data(),
										  rows.data(), values.data());
}

SparseMatrix DefectJacobian::along(const Positions& directions) const {
	std::vector<double> values(rowOfBlock_.size());
	for (int place = 0; place < assembly_.placeCount(); ++place)
		for (int block = blockStart_[place]; block < blockStart_[place + 1]; ++block)
			values[block] = blocks_.col(block).dot(directions.col(place));
	return Eigen::Map<const SparseMatrix>(rowCount(), assembly_.placeCount(), values.size(),
										  blockStart_.data(), rowOfBlock_.data(), values.data());
}

std::vector<int> DefectJacobian::rowOrder(const std::vector<int>& placeOrder) const {
	std::vector<std::vector<int>> rowsOfPlace(placeOrder.size());
	for (int row = 0; row < rowCount(); ++row)
		rowsOfPlace[placeOfRow(row)].push_back(row);
	std::vector<int> order;
	order.reserve(rowCount());
	for (const int place : placeOrder)
		order.insert(order.end(), rowsOfPlace[place].begin(), rowsOfPlace[place].end());
	return order;
}

const SparseMatrix& DefectJacobian::massProduct(double shift) {
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

void DefectJacobian::findBlocks() {
	std::vector<std::pair<int, int>> uses; // row, 9 * triangle + 3 * corner + vertex
	std::vector<int> placeOfUse;
	forEachUse([&](int use, int row, int place) {
		uses.emplace_back(row, use);
		placeOfUse.push_back(place);
	});
	const Groups byPlace = grouped(assembly_.placeCount(), static_cast<int>(uses.size()),
								   [&](int use) { return placeOfUse[use]; });
	blockOf_.assign(9 * static_cast<std::size_t>(assembly_.triangleCount()) + 3 * turns_.joints().size(), -1);
	blockStart_.assign(1, 0);
	rowOfBlock_.reserve(uses.size() / 2);
	for (int place = 0; place < assembly_.placeCount(); ++place) {
		std::vector<std::pair<int, int>> usesOfPlace;
		for (const int* use = byPlace.begin(place); use != byPlace.end(place); ++use)
			usesOfPlace.push_back(uses[*use]);
		std::sort(usesOfPlace.begin(), usesOfPlace.end());
		for (const auto& [row, use] : usesOfPlace) {
			if (static_cast<int>(rowOfBlock_.size()) == blockStart_.back() || rowOfBlock_.back() != row)
				rowOfBlock_.push_back(row);
			blockOf_[use] = static_cast<int>(rowOfBlock_.size()) - 1;
		}
		blockStart_.push_back(static_cast<int>(rowOfBlock_.size()));
	}
	blocks_.resize(3, rowOfBlock_.size());
}

void DefectJacobian::findProducts() {
	std::vector<Eigen::Triplet<double>> entries;
	entries.reserve(rowCount());
	for (int row = 0; row < rowCount(); ++row)
		entries.emplace_back(row, row, 0);
	forEachProduct([&](int row, int column) { entries.emplace_back(row, column, 0); });
	product_.resize(rowCount(), rowCount());
	product_.setFromTriplets(entries.begin(), entries.end());
	productEntry_.reserve(entries.size());
	forEachProduct([&](int row, int column) { productEntry_.push_back(storedPlace(product_, row, column)); });
}

} // namespace developable::detail
