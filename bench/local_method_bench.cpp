// SPDX-License-Identifier: GPL-3.0-or-later
// local_method_bench.cpp: what an operation of the local method costs, at growing sizes.
//
// Prints one line a size: vertices, nanoseconds an operation, the same when self-intersections are avoided,
// and the seconds of the whole run, without and with that.
#include "developable/local/local_method.h"
#include "support/processor_time.h"
#include "support/shapes.h"

#include <cstdio>

namespace {

using namespace developable;

struct Cost {
	double operation; ///< ns, with what is done once before the first taken off
	double run;       ///< s
};

/// Two visits a vertex: nearly all of them move it, at every size.
Cost cost(const PatchAssembly& assembly, bool avoidSelfIntersections) {
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
	return {1e9 * (whole - before) / static_cast<double>(operations), whole};
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
		const Cost plain = cost(assembly, false), avoiding = cost(assembly, true);
		std::printf("%d %.0f %.0f %g %g\n", mesh.vertexCount(), plain.operation, avoiding.operation,
					plain.run, avoiding.run);
		std::fflush(stdout);
	}
}
