// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_metric.h: the metric and the soundness of the constrained Newton method, for other methods.
#pragma once

#include "developable/linear/linear.h"
#include "developable/mesh/mesh.h"

namespace developable {

/// The lower triangle of W, places x places, the same for all three coordinates: ‖d‖²_W measures how far a
/// displacement d moves the surface from the original positions and how much it bends it, length² (see
/// docs/constrained_newton.md). Rows of places that are held still are those of a diagonal matrix.
/// \param smoothness  α, without unit
SparseMatrix displacementMetric(const PatchAssembly& assembly, double smoothness);

/// What a shape is to be near, and in what metric. \see NewtonProblem
struct Nearness {
	SparseMatrix metric; ///< as displacementMetric has it
	Positions aim;       ///< 3 x places: the original, with waves smoothed away where fairness asks for it

	/// ‖x − aim‖²_W, length².
	double squaredDistance(const Positions& shape) const;
};

/// \param fairness  0 to 1, as in ConstrainedNewtonOptions
Nearness nearness(const PatchAssembly& assembly, double smoothness, double fairness);

/// How far the place that has moved farthest is from where it was, length.
double farthestMove(const PatchAssembly& assembly, const Positions& positions);

/// How far places may go: what was asked for, or 15 % of the diagonal of the part where that is negative.
double farthestAllowed(const PatchAssembly& part, double maxDisplacement);

/// Whether no triangle is flipped, and none has become a sliver, compared with the original.
class TriangleOrder {
public:
	explicit TriangleOrder(const PatchAssembly& assembly);
	TriangleOrder(TriangleOrder&&) noexcept;
	~TriangleOrder();

	bool holds(const Positions& positions) const;

private:
	class Comparison;

	std::unique_ptr<Comparison> comparison_;
};

} // namespace developable
