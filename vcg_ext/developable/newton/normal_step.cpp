// SPDX-License-Identifier: GPL-3.0-or-later
// normal_step.cpp: put together, factorised and solved.
#include "normal_step.h"

namespace developable::detail {

bool NormalStep::factorize(const Shape& shape, const Eigen::VectorXd& rowWeights, double& epsilon) {
	const NewtonTuning& tuning = problem_.tuning();
	problem_.jacobian().linearize(shape.positions);
	normals_ = placeNormals(problem_.assembly(), shape.positions);
	along_ = problem_.jacobian().along(normals_);
	Eigen::VectorXd defects = shape.scaledDefects;
	if (rowWeights.size() > 0) {
		along_ = rowWeights.asDiagonal() * along_;
		defects.array() *= rowWeights.array();
	}
	if (epsilon == 0) // normals are one long, so W and NᵀWN have the same trace
		epsilon = tuning.firstDamping * along_.squaredNorm() / problem_.metric().matrix().diagonal().sum();
	const Eigen::VectorXd downward = -(along_.transpose() * defects);
	NormalSystem& system = problem_.normalSystem();
	for (int i = 0; system.factorize(along_, normals_, problem_.metric().matrix(), epsilon); ++i) {
		problem_.budget().spendOperations(system.operations());
		problem_.budget().spend(problem_.assembly().placeCount());
		const Eigen::VectorXd lengths = system.solve(downward);
		whole_ = normals_ * lengths.asDiagonal();
		slope_ = -downward.dot(lengths);
		if (i == tuning.stiffenings || problem_.metric().tooStiff() ||
			!problem_.stiffenFor(shape.positions + whole_))
			return true;
	}
	return false;
}

Positions NormalStep::chord(const Shape& shape) const {
	const Eigen::VectorXd downward = -(along_.transpose() * shape.scaledDefects);
	return normals_ * problem_.normalSystem().solve(downward).asDiagonal();
}

} // namespace developable::detail
