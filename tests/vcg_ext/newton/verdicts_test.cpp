// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on some shapes, with whatever solves linear systems: these tests are compiled a second time
// into a program whose systems Eigen factorises.
#include "support/newton_checks.h"

namespace developable::test {
namespace {

struct Case {
	const char* name;
	TriangleMesh mesh;
	Status expected;
	double meanMove; ///< of the diagonal, per cent, to a tenth of itself
};

std::vector<Case> cases() {
	return {{"flat", grid(9, 9, flatSheet), Status::NothingToDo, 0},
			{"cylinder", grid(9, 9, quarterCylinder), Status::NothingToDo, 0},
			{"saddle", jitteredGrid(15, 15, saddle), Status::Converged, 0.486},
			{"wave", jitteredGrid(15, 15, wave), Status::Converged, 0.432},
			{"bump", jitteredGrid(15, 15, bumpedCylinder), Status::Converged, 0.388},
			{"tunnel", jitteredGrid(11, 15, vamp), Status::Converged, 1.228}};
}

void expectVerdicts(const ConstrainedNewtonOptions& options) {
	for (const Case& shape : cases()) {
		const PatchAssembly assembly = assembled(shape.mesh);
		Positions positions = assembly.originalPositions;
		EXPECT_EQ(constrainedNewton(assembly, positions, options).status, shape.expected) << shape.name;
		const double moved = 100 * displacementMap(assembly.originalPositions, positions).mean() /
							 boxDiagonal(assembly.originalPositions);
		EXPECT_NEAR(moved, shape.meanMove, 0.1 * shape.meanMove) << shape.name;
	}
}

TEST(Verdicts, AreTheSameHoweverSystemsAreFactorised) {
	expectVerdicts({});
}

TEST(Verdicts, AreTheSameByIteration) {
	ConstrainedNewtonOptions options;
	options.memoryLimit = 1;
	expectVerdicts(options);
}

TEST(Verdicts, AreTheSameInAllCoordinatesAtOnce) {
	ConstrainedNewtonOptions options;
	options.tuning.slowSystem = options.tuning.slowStiffSystem = 0;
	expectVerdicts(options);
}

} // namespace
} // namespace developable::test
