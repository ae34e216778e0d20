// SPDX-License-Identifier: GPL-3.0-or-later
// fitted_hessian.cpp: the least squares of a triangle's hinges.
#include "fitted_hessian.h"

#include "unfolded_hinges.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace developable::detail {

namespace {

constexpr int widest = 3;             ///< how far round a triangle hinges are looked for, in triangles
constexpr double wellEnough = 0.05;   ///< the least eigenvalue of a fit that needs no more hinges
constexpr double undetermined = 1e-9; ///< below it an eigenvalue is rounding
constexpr double unexplained = 0.5;   ///< γ

/// A symmetric matrix as a vector of the same norm.
Eigen::Vector3d asVector(const Eigen::Matrix2d& symmetric) {
	return {symmetric(0, 0), std::sqrt(2.0) * symmetric(0, 1), symmetric(1, 1)};
}

Eigen::Matrix2d asMatrix(const Eigen::Vector3d& vector) {
	Eigen::Matrix2d symmetric;
	symmetric << vector[0], vector[1] / std::sqrt(2.0), vector[1] / std::sqrt(2.0), vector[2];
	return symmetric;
}

/// Fits in coordinates in which the triangle is equilateral, so that a stretched triangulation is as good as
/// another.
class Fit {
public:
	explicit Fit(const std::vector<Eigen::Vector2d>& triangle) {
		Eigen::Matrix2d edges, equilateral;
		edges << triangle[1] - triangle[0], triangle[2] - triangle[0];
		equilateral << 1, 0.5, 0, std::sqrt(0.75);
		toEquilateral_ = equilateral * edges.inverse();
	}

	void add(const Eigen::Matrix2d& response) {
		const Eigen::Vector3d row = asVector(toEquilateral_ * response * toEquilateral_.transpose());
		responses_.push_back(row.normalized());
		scales_.push_back(1 / row.norm());
		gram_ += responses_.back() * responses_.back().transpose();
	}

	/// To be called when all are added, for the time being.
	void analyze() { eigen_.compute(gram_); }
	double leastEigenvalue() const { return eigen_.eigenvalues()[0]; }

	/// What one unit of each hinge's jump adds to the Hessian, as a vector: 3 x hinges.
	Eigen::Matrix3Xd solution() const {
		const Eigen::Vector3d& values = eigen_.eigenvalues();
		Eigen::Vector3d inverse;
		for (int i = 0; i < 3; ++i)
			inverse[i] = values[i] > undetermined * values[2] ? 1 / values[i] : 0;
		const Eigen::Matrix3d solve =
			eigen_.eigenvectors() * inverse.asDiagonal() * eigen_.eigenvectors().transpose();
		Eigen::Matrix3Xd result(3, responses_.size());
		for (std::size_t i = 0; i < responses_.size(); ++i)
			result.col(i) =
				asVector(toEquilateral_.transpose() * asMatrix(solve * responses_[i]) * toEquilateral_) *
				scales_[i];
		return result;
	}

private:
	Eigen::Matrix2d toEquilateral_;
	std::vector<Eigen::Vector3d> responses_;
	std::vector<double> scales_;
	Eigen::Matrix3d gram_ = Eigen::Matrix3d::Zero();
	Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_;
};

/// Adds a hinge's jump to rows, one share of it to each.
template <class Rows, class Shares>
void addJump(const UnfoldedHinge& hinge, const Shares& shares, Rows&& rows) {
	for (int i = 0; i < 4; ++i)
		rows.col(hinge.points[i]) += hinge.jump[i] * shares;
}

} // namespace

FittedHessian::FittedHessian(const PatchAssembly& assembly, const Eigen::VectorXd& areas)
	: assembly_(assembly), areas_(areas) {}

TriangleBending FittedHessian::bending(int triangle) const {
	UnfoldedHinges unfolded(assembly_, areas_, triangle);
	Fit fit(unfolded.points());
	std::size_t own = 0, fitted = 0;
	for (int round = 0; round < widest && unfolded.widen(); ++round) {
		const auto& hinges = unfolded.hinges();
		for (; fitted < hinges.size(); ++fitted)
			fit.add(hinges[fitted].response);
		fit.analyze();
		if (round == 0)
			own = fitted;
		if (fit.leastEigenvalue() > wellEnough)
			break;
	}
	TriangleBending result;
	result.determined = fitted >= 3 && fit.leastEigenvalue() > undetermined;
	if (fitted == 0)
		return result;
	const auto& hinges = unfolded.hinges();
	const bool exact = fitted == 3 && result.determined;
	result.places = unfolded.places();
	result.rows.setZero(exact ? 3 : 3 + own, result.places.size());
	const Eigen::Matrix3Xd solution = fit.solution();
	auto hessian = result.rows.topRows(3);
	for (std::size_t i = 0; i < fitted; ++i)
		addJump(hinges[i], solution.col(i), hessian);
	for (std::size_t i = 0; !exact && i < own; ++i) {
		auto row = result.rows.row(3 + i);
		row = -asVector(hinges[i].response).transpose() * hessian;
		addJump(hinges[i], Eigen::Matrix<double, 1, 1>::Ones(), row);
		row *= std::sqrt(unexplained / hinges[i].area);
	}
	hessian *= std::sqrt(areas_[triangle]);
	return result;
}

} // namespace developable::detail
