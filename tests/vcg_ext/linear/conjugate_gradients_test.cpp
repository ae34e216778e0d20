// SPDX-License-Identifier: GPL-3.0-or-later
#include "developable/linear/conjugate_gradients.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>

namespace developable::test {
namespace {

using Vector = Eigen::VectorXd;

constexpr int unknowns = 8;

/// A system with a solution that is known, and what was asked of it.
struct System {
	Eigen::MatrixXd matrix;
	Vector solution, rightHandSide;
	int steps = 0, applications = 0;

	explicit System(const Eigen::MatrixXd& a) : matrix(a), solution(Vector::LinSpaced(a.rows(), -1, 2)) {
		rightHandSide = matrix * solution;
	}

	template <class Precondition>
	Iterated solve(const Precondition& precondition, int stepLimit, Vector& x, int stepsAllowed = 1000) {
		steps = applications = 0;
		return conjugateGradients(
			[this](const Vector& v) {
				++applications;
				return Vector(matrix * v);
			},
			precondition, rightHandSide, stepLimit,
			[this](const Vector& r, double) { return r.norm() <= 1e-11 * rightHandSide.norm(); },
			[this, stepsAllowed] { return steps++ < stepsAllowed; }, x);
	}

	Iterated solve(int stepLimit, Vector& x, int stepsAllowed = 1000) {
		return solve([](const Vector& v) { return v; }, stepLimit, x, stepsAllowed);
	}

	Vector zero() const { return Vector::Zero(matrix.rows()); }
};

/// Symmetric positive definite, with eigenvalues from 1 to about 10.
Eigen::MatrixXd definiteMatrix() {
	Eigen::MatrixXd matrix(unknowns, unknowns);
	for (int i = 0; i < unknowns; ++i)
		for (int j = 0; j < unknowns; ++j)
			matrix(i, j) = (i == j ? 1.0 + i : 0) + 1.0 / (1 + std::abs(i - j));
	return matrix;
}

TEST(ConjugateGradients, SolveASmallSystemInAsManyStepsAsItHasRows) {
	System system(definiteMatrix());
	Vector x = system.zero();
	EXPECT_EQ(system.solve(unknowns, x), Iterated::Enough);
	EXPECT_LE(system.steps, unknowns);
	EXPECT_GT(system.steps, 3);
	EXPECT_EQ(system.applications, system.steps); // none for the residual of a zero vector
	EXPECT_LT((x - system.solution).norm(), 1e-10);
}

TEST(ConjugateGradients, TakeAStepForEachDifferentEigenvalue) {
	Vector eigenvalues(30);
	for (int i = 0; i < 30; ++i)
		eigenvalues[i] = std::vector<double>{0.5, 3, 20}[i % 3];
	const Eigen::MatrixXd basis =
		Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Identity(30, 30) +
											  Eigen::MatrixXd::Constant(30, 30, 0.3))
			.householderQ();
	System system(basis * eigenvalues.asDiagonal() * basis.transpose());
	Vector x = system.zero();
	EXPECT_EQ(system.solve(2, x), Iterated::LimitOfSteps);
	x.setZero();
	EXPECT_EQ(system.solve(3, x), Iterated::Enough);
	EXPECT_EQ(system.steps, 3);
}

TEST(ConjugateGradients, NearTheSolutionTakeFewerSteps) {
	System system(definiteMatrix());
	Vector cold = system.zero(), warm = system.solution + 1e-9 * Vector::LinSpaced(unknowns, 1, 2);
	ASSERT_EQ(system.solve(unknowns, cold), Iterated::Enough);
	const int stepsFromZero = system.steps;
	EXPECT_EQ(system.solve(unknowns, warm), Iterated::Enough);
	EXPECT_LT(system.steps, stepsFromZero);
	EXPECT_GT(system.steps, 0);
	EXPECT_LT((warm - system.solution).norm(), 1e-10);
}

TEST(ConjugateGradients, TakeOneStepWithTheInverseAsPreconditioner) {
	System system(definiteMatrix());
	const Eigen::MatrixXd inverse = system.matrix.inverse();
	Vector x = system.zero();
	EXPECT_EQ(system.solve([&](const Vector& v) { return Vector(inverse * v); }, unknowns, x),
			  Iterated::Enough);
	EXPECT_EQ(system.steps, 1);
	EXPECT_LT((x - system.solution).norm(), 1e-10);
}

TEST(ConjugateGradients, SayThatTheOperatorIsNotPositiveDefinite) {
	// The first direction, the right-hand side, already shows it: x stays.
	System negative(-definiteMatrix());
	Vector x = negative.zero();
	EXPECT_EQ(negative.solve(unknowns, x), Iterated::Indefinite);
	EXPECT_EQ(x, negative.zero());
	// A singular operator, and one that is no number.
	for (const double value : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
		System system(definiteMatrix());
		system.matrix.setConstant(value);
		EXPECT_EQ(system.solve(unknowns, x), Iterated::Indefinite);
		EXPECT_EQ(x, system.zero());
	}
	// One negative eigenvalue of little weight shows later: x is what one step less gives.
	Eigen::MatrixXd indefinite = definiteMatrix();
	indefinite(unknowns - 1, unknowns - 1) = -0.1;
	System system(indefinite);
	EXPECT_EQ(system.solve(unknowns, x), Iterated::Indefinite);
	ASSERT_GT(system.steps, 1);
	Vector before = system.zero();
	EXPECT_EQ(system.solve(system.steps - 1, before), Iterated::LimitOfSteps);
	EXPECT_EQ(x, before);
	EXPECT_GT(x.norm(), 0);
}

TEST(ConjugateGradients, StopBeforeTheStepThatIsNotAllowed) {
	System system(definiteMatrix());
	Vector stopped = system.zero(), limited = system.zero();
	EXPECT_EQ(system.solve(unknowns, stopped, 3), Iterated::Stopped);
	EXPECT_EQ(system.applications, 3);
	EXPECT_EQ(system.solve(3, limited), Iterated::LimitOfSteps);
	EXPECT_EQ(stopped, limited);
	Vector untouched = system.zero();
	EXPECT_EQ(system.solve(unknowns, untouched, 0), Iterated::Stopped);
	EXPECT_EQ(untouched, system.zero());
}

TEST(ConjugateGradients, EveryStepUpToTheLimitLeavesLess) {
	System system(definiteMatrix());
	double before = std::numeric_limits<double>::infinity();
	for (int limit = 0; limit < 6; ++limit) {
		Vector x = system.zero();
		EXPECT_EQ(system.solve(limit, x), Iterated::LimitOfSteps);
		EXPECT_EQ(system.applications, limit);
		const Vector error = x - system.solution;
		EXPECT_LT(error.dot(system.matrix * error), before); // what conjugate gradients make least
		before = error.dot(system.matrix * error);
	}
}

TEST(ConjugateGradients, AskWhetherItIsEnoughBeforeTheFirstStep) {
	System system(definiteMatrix());
	Vector exact = system.solution;
	EXPECT_EQ(system.solve(0, exact), Iterated::Enough);
	EXPECT_EQ(system.steps, 0);
	EXPECT_EQ(exact, system.solution);
	system.rightHandSide.setZero();
	Vector x = system.zero();
	EXPECT_EQ(system.solve(0, x), Iterated::Enough);
	EXPECT_EQ(system.applications, 0);
	EXPECT_EQ(x, system.zero());
}

TEST(ConjugateGradients, TellTheResidualAndItsPreconditionedSquare) {
	const System system(definiteMatrix());
	const Vector inverseDiagonal = system.matrix.diagonal().cwiseInverse();
	const auto precondition = [&](const Vector& v) { return Vector(inverseDiagonal.cwiseProduct(v)); };
	Vector x = Vector::Ones(unknowns);
	int asked = 0;
	const auto enough = [&](const Vector& residual, double product) {
		EXPECT_LT((residual - (system.rightHandSide - system.matrix * x)).norm(), 1e-12);
		EXPECT_EQ(product, residual.dot(precondition(residual)));
		return ++asked == 5;
	};
	EXPECT_EQ(conjugateGradients([&](const Vector& v) { return Vector(system.matrix * v); }, precondition,
								 system.rightHandSide, unknowns, enough, [] { return true; }, x),
			  Iterated::Enough);
	EXPECT_EQ(asked, 5);
}

} // namespace
} // namespace developable::test
