// SPDX-License-Identifier: GPL-3.0-or-later
// local_method_bench.cpp: what an operation of the local method costs, at growing sizes.
//
// Prints one line a size: vertices, nanoseconds an operation, the same when self-intersections are avoided.
#include "developable/local_method.h"
#include "support/processor_time.h"
#include "support/shapes.h"

#include <cstdio>

namespace {

using namespace developable;

/// Nanoseconds an operation, with what is done once before the first taken off. Two visits a vertex: nearly
/// all of them move it, at every size.
double nanosecondsAnOperation(const PatchAssembly& assembly, bool avoidSelfIntersections) {
	LocalMethodOptions options;
	options.angleTolerance = 0;
	options.avoidSelfIntersections = avoidSelfIntersections;
	long operations = 0;
	const auto seconds = [&](long limit) {
		options.maxOperations = limit;
		const auto run = [&] {
			Positions positions = assembly.originalPositions;
			operations = localMethod(assembly, positions, options).iterations;
		};
		return test::leastSeconds(run, std::max(3, 300000 / assembly.placeCount()));
	};
	const double before = seconds(1);
	const double whole = seconds(2L * assembly.placeCount());
	return 1e9 * (whole - before) / static_cast<double>(operations);
}

} // namespace

int main() {
	for (const int side : {32, 100, 316, 1000}) {
		// Noise gives every vertex something to do for as long as is measured.
		TriangleMesh mesh = test::jitteredGrid(side, side, test::bumpedCylinder);
		std::mt19937 random(1);
		for (double& coordinate : mesh.positions.reshaped())
			coordinate += 0.02 / side * (2.0 * random() / std::mt19937::max() - 1);
		const PatchAssembly assembly = assemblePatches(mesh, {});
		std::printf("%d %.0f %.0f\n", mesh.vertexCount(), nanosecondsAnOperation(assembly, false),
					nanosecondsAnOperation(assembly, true));
		std::fflush(stdout);
	}
}
