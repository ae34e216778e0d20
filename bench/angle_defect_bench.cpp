// SPDX-License-Identifier: GPL-3.0-or-later
// angle_defect_bench.cpp: nanoseconds a triangle for angle defects and their gradient, bytes a triangle for
// the paper's methods. Writes the mesh that was measured, for bench/angle_defect.py to measure MeshLab on.
//
// angle_defect_bench TRIANGLES MESH.off -> one line: triangles, ns of defects, ns of the gradient, ns of both
// without AVX2, bytes of global and local
#include "developable/local/local_method.h"
#include "developable/penalty/penalty_method.h"
#include "support/processor_time.h"
#include "support/shapes.h"
#include "vcg_ext/geometry/kernel_results.h"

#include <cstdio>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace developable;

double peakBytes() {
	rusage usage;
	getrusage(RUSAGE_SELF, &usage);
	return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double residentBytes() {
	long pages = 0, resident = 0;
	std::FILE* file = std::fopen("/proc/self/statm", "r");
	if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2)
		resident = 0;
	std::fclose(file);
	return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void writeOff(const char* path, const TriangleMesh& mesh) {
	std::FILE* file = std::fopen(path, "w");
	std::fprintf(file, "OFF\n%d %d 0\n", mesh.vertexCount(), mesh.triangleCount());
	for (const auto& p : mesh.positions.colwise())
		std::fprintf(file, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
	for (const auto& t : mesh.triangles.colwise())
		std::fprintf(file, "3 %d %d %d\n", t[0], t[1], t[2]);
	std::fclose(file);
}

} // namespace

int main(int count, char** arguments) {
	if (count != 3) {
		std::fprintf(stderr, "usage: angle_defect_bench TRIANGLES MESH.off\n");
		return 2;
	}
	const int side = static_cast<int>(std::lround(std::sqrt(std::atof(arguments[1]) / 2))) + 1;
	const TriangleMesh mesh = test::jitteredGrid(side, side, test::bumpedCylinder);
	writeOff(arguments[2], mesh);
	const double before = residentBytes();
	const PatchAssembly assembly = assemblePatches(mesh, {});
	const Positions& positions = assembly.originalPositions;
	const int runs = mesh.triangleCount() > 300000 ? 5 : 30;
	Eigen::VectorXd defects;
	const double defectSeconds =
		test::leastSeconds([&] { defects = angleDefects(assembly, positions); }, runs);
	Positions gradient;
	const double gradientSeconds =
		test::leastSeconds([&] { gradient = detectFunctionGradient(assembly, positions, defects); }, runs);
	const double narrow =
		test::leastSeconds([&] { test::kernelResults<detail::TwoNumbers>(assembly); }, runs); // no AVX2

	Positions moved = positions;
	LocalMethodOptions localOptions;
	localOptions.angleTolerance = 0;
	localOptions.maxOperations = 1000;
	localMethod(assembly, moved, localOptions);
	const double localBytes = peakBytes() - before;
	moved = positions;
	PenaltyMethodOptions globalOptions;
	globalOptions.angleTolerance = 0;
	globalOptions.maxIterations = 1;
	penaltyMethod(assembly, moved, globalOptions);
	const double globalBytes = peakBytes() - before;

	const double triangles = mesh.triangleCount();
	std::printf("%d %.2f %.2f %.2f %.0f %.0f\n", mesh.triangleCount(), 1e9 * defectSeconds / triangles,
				1e9 * gradientSeconds / triangles, 1e9 * narrow / triangles, globalBytes / triangles,
				localBytes / triangles);
}
