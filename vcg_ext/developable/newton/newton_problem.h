// SPDX-License-Identifier: GPL-3.0-or-later
// newton_problem.h: the problem that the constrained Newton method solves on one level.
#pragma once

#include "bending_metric.h"
#include "curvature_goal.h"
#include "defect_jacobian.h"
#include "normal_system.h"
#include "soundness.h"
#include "work_budget.h"

#include <memory>
#include <optional>

namespace developable::detail {

/// A shape with what decides about it.
struct Shape {
	Positions positions;
	Eigen::VectorXd scaledDefects; ///< g as DefectJacobian scales it
	double curvature = 0;          ///< C, rad
	double farthest = 0;           ///< how far the farthest place is from where it was, length
	bool reached = false;          ///< every patch is developable

	/// |g|².
	double squaredDefects() const { return scaledDefects.squaredNorm(); }
};

/// How far a place of a part had better move at most, length.
double preferredMove(const PatchAssembly& part, const NewtonTuning& tuning, const CurvatureGoal& goal);

/// Of all sound shapes with g = 0 the one is sought whose displacement d from the original has the least
/// ‖d‖_W. What steps of every kind need for that is held here once: the goal, the metric W, the derivative J
/// of g, and what a sound shape is.
class NewtonProblem {
public:
	/// \param memoryLimit  see SparseSolver
	NewtonProblem(const PatchAssembly& assembly, const CurvatureGoal& goal, const NewtonTuning& tuning,
				  double memoryLimit)
		: NewtonProblem(assembly, assembly, goal, tuning, memoryLimit, 0) {}

	/// \param reference        the same assembly with other original positions: what the shape is to be near,
	///                         and where displacements are measured from; see fairShape
	/// \param shapeSmoothness  φ: how dear it is to bend the shape, beside α
	NewtonProblem(const PatchAssembly& assembly, const PatchAssembly& reference, const CurvatureGoal& goal,
				  const NewtonTuning& tuning, double memoryLimit, double shapeSmoothness);

	/// The same problem as it was at first, with a budget of its own: for another thread.
	std::unique_ptr<NewtonProblem> another() const;

	/// The metric anew: every triangle is as stiff as at first.
	/// \param smoothness  α, the same in all patches
	void setSmoothness(double smoothness);

	Shape shapeAt(const Positions& positions) const;

	/// From the reference.
	Positions displacement(const Shape& shape) const {
		return shape.positions - reference_.originalPositions;
	}

	/// Whether the mean displacement is at most a little longer than another's.
	bool hardlyFarther(const Shape& shape, const Shape& other) const;

	/// Whether it has come farther than may be on the way, see NewtonTuning::wayFarthest.
	bool beyondWay(const Shape& shape) const;

	/// Makes places heavier, see BendingMetric.
	void weigh(const Eigen::VectorXd& masses);
	/// Makes places as heavy as this, whatever they are by then; see BendingMetric::weight.
	void setWeight(const Eigen::VectorXd& weight) { weigh(weight - metric_.weight()); }

	/// Where a step would spoil triangles they are made stiffer. \return whether there are any
	bool stiffenFor(const Positions& positions);

	const PatchAssembly& assembly() const { return assembly_; }
	const CurvatureGoal& goal() const { return goal_; }
	const NewtonTuning& tuning() const { return tuning_; }
	double memoryLimit() const { return memoryLimit_; }
	double diagonal() const { return diagonal_; }
	/// How far a place had better move at most, length.
	double preferredMove() const { return std::min(tuning_.preferredBound(diagonal_), goal_.farthest); }
	BendingMetric& metric() { return metric_; }
	const BendingMetric& metric() const { return metric_; }
	DefectJacobian& jacobian() { return jacobian_; }
	const DefectJacobian& jacobian() const { return jacobian_; }
	const Soundness& soundness() const { return soundness_; }
	/// That of steps along the normals.
	NormalSystem& normalSystem();
	/// Finds its pattern beforehand.
	void prepareNormalSystem();
	/// Gives back the memory of its factor.
	void forgetNormalSystem() { normalSystem_.reset(); }

	/// What all work on this problem is taken from; at first without limit.
	WorkBudget& budget() const { return *budget_; }
	void setBudget(std::shared_ptr<WorkBudget> budget) { budget_ = std::move(budget); }

private:
	void findEliminationOrder();

	const PatchAssembly &assembly_, &reference_;
	const CurvatureGoal goal_;
	const NewtonTuning tuning_;
	const double memoryLimit_, diagonal_;
	BendingMetric metric_;
	DefectJacobian jacobian_;
	Soundness soundness_;
	std::optional<NormalSystem> normalSystem_;
	const double shapeSmoothness_; // φ
	std::shared_ptr<WorkBudget> budget_ = std::make_shared<WorkBudget>();
};

} // namespace developable::detail
