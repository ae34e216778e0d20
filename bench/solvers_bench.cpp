// SPDX-License-Identifier: GPL-3.0-or-later
// solvers_bench: makes shapes, runs one method on one mesh, and measures what it did; see solvers.py.
#include "developable/flatten/flatten.h"
#include "developable/geometry/geometry.h"
#include "developable/local/local_method.h"
#include "developable/newton/constrained_newton.h"
#include "developable/penalty/penalty_method.h"

#include "least_norm.h"
#include "support/shapes.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>

using namespace developable;

namespace {

Eigen::Vector3d strongBump(double u, double v) {
	const double angle = 2 * (u - 0.5), distance = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
	const double radius = 1 + 0.15 * std::exp(-20 * distance);
	return {radius * std::sin(angle), 2 * v, radius * std::cos(angle)};
}

TriangleMesh withTwoHoles(const TriangleMesh& mesh, int columns) {
	std::vector<int> kept;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const double u = double(t / 2 % (columns - 1)) / columns, v = double(t / 2 / (columns - 1)) / columns;
		if (std::hypot(u - 0.3, v - 0.35) >= 0.1 && std::hypot(u - 0.65, v - 0.6) >= 0.12)
			kept.push_back(t);
	}
	return test::makeMesh(mesh.positions, mesh.triangles(Eigen::all, kept));
}

TriangleMesh shape(const std::string& name, int columns, double noise) {
	const std::map<std::string, test::Surface> surfaces = {
		{"cap", test::sphereCap(1)}, {"saddle", test::largeSaddle}, {"bump", strongBump},
		{"wave", test::wave},        {"vamp", test::vamp},          {"steep_bump", test::steepBump},
		{"holes", strongBump}};
	TriangleMesh mesh = test::jitteredGrid(columns, columns, surfaces.at(name));
	const double amount = noise * meanEdgeLength(test::assembled(mesh));
	std::mt19937 random(11);
	for (double& coordinate : mesh.positions.reshaped())
		coordinate += amount * std::sqrt(3.0) * (2.0 * random() / std::mt19937::max() - 1);
	return name == "holes" ? withTwoHoles(mesh, columns) : mesh;
}

TriangleMesh readOff(const std::string& path) {
	std::ifstream file(path);
	std::string word;
	int vertices = 0, triangles = 0, corners = 0;
	file >> word >> vertices >> triangles >> corners;
	Positions positions(3, vertices);
	for (double& coordinate : positions.reshaped())
		file >> coordinate;
	Eigen::Matrix3Xi indices(3, triangles);
	for (int t = 0; t < triangles; ++t)
		file >> corners >> indices(0, t) >> indices(1, t) >> indices(2, t);
	if (!file || corners != 3)
		throw std::runtime_error("not an OFF file of triangles: " + path);
	return test::makeMesh(positions, indices);
}

void writeOff(const std::string& path, const Positions& positions, const Eigen::Matrix3Xi& triangles) {
	std::ofstream file(path);
	file.precision(17);
	file << "OFF\n" << positions.cols() << ' ' << triangles.cols() << " 0\n";
	for (const auto& p : positions.colwise())
		file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
	for (const auto& t : triangles.colwise())
		file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

/// \param changes  of tuning constants and of the smoothness, each a name and a factor; and of the fairness,
/// a value
ConstrainedNewtonOptions tuned(const std::vector<std::string>& changes) {
	ConstrainedNewtonOptions options;
	for (std::size_t i = 0; i + 1 < changes.size(); i += 2) {
		if (changes[i] == "smoothness")
			options.smoothness *= std::stod(changes[i + 1]);
		if (changes[i] == "curvatureTolerance")
			options.curvatureTolerance *= std::stod(changes[i + 1]);
		if (changes[i] == "fairness")
			options.fairness = std::stod(changes[i + 1]);
		for (const TuningConstant& constant : tuningConstants())
			if (constant.name == changes[i])
				constant.set(options.tuning, std::stod(changes[i + 1]) * constant.value(options.tuning));
	}
	return options;
}

std::string runMethod(const std::string& method, const PatchAssembly& assembly, Positions& positions,
					  const std::vector<std::string>& changes) {
	if (method == "constrained_newton") {
		const ConstrainedNewtonReport report = constrainedNewton(assembly, positions, tuned(changes));
		return describe(report.status).substr(0, describe(report.status).find(':'));
	}
	if (method == "conjugate_gradient")
		return describe(penaltyMethod(assembly, positions, {}).status);
	if (method == "conjugate_gradient_200") {
		PenaltyMethodOptions options;
		options.relativeChange = options.angleTolerance = 0;
		return describe(penaltyMethod(assembly, positions, options).status);
	}
	if (method == "local")
		return describe(localMethod(assembly, positions, {}).status);
	if (method == "least_norm")
		return leastNorm(assembly, positions);
	throw std::runtime_error("unknown method " + method);
}

Eigen::VectorXd hingeAngles(const PatchAssembly& assembly, const Positions& positions) {
	const auto normal = [&](int triangle) -> Eigen::Vector3d {
		const auto places = assembly.trianglePlaces.col(triangle);
		const TriangleFrame frame(positions.col(places[0]), positions.col(places[1]),
								  positions.col(places[2]));
		return (assembly.triangleReversed[triangle] ? -1 : 1) * frame.normal.normalized();
	};
	std::vector<double> angles;
	for (int edge = 0; edge < assembly.edgeCount(); ++edge) {
		const int half = assembly.edgeHalfEdge[edge], across = assembly.joinedHalfEdge[half];
		if (across < 0)
			continue;
		const Eigen::Vector3d a = normal(half / 3), b = normal(across / 3);
		const Eigen::Vector3d along =
			(positions.col(assembly.edgePlaces(1, edge)) - positions.col(assembly.edgePlaces(0, edge)))
				.normalized();
		angles.push_back(std::atan2(a.cross(b).dot(along), a.dot(b)));
	}
	return Eigen::Map<Eigen::VectorXd>(angles.data(), angles.size());
}

/// Greatest edge strain of the flat patterns; not a number when there are none.
double flattenedStrain(const PatchAssembly& assembly, const Positions& positions) {
	try {
		return flattenPatches(assembly, positions, {}).report.maxEdgeStrain;
	} catch (const std::exception&) {
		return std::nan("");
	}
}

/// Prints what the table shows, blank between numbers; lengths in % of the diagonal, angles in degrees.
void printMeasures(const PatchAssembly& assembly, const Positions& positions) {
	const Positions& original = assembly.originalPositions;
	const double percent = 100 / boxDiagonal(original);
	const Measures before = measure(assembly, original, 1e-4), after = measure(assembly, positions, 1e-4);
	const Eigen::VectorXd displacement = percent * (positions - original).colwise().norm();
	const Eigen::VectorXd distance =
		percent * distancesToSurface(positions, original, assembly.trianglePlaces);
	const Eigen::VectorXd anglesBefore = hingeAngles(assembly, original),
						  angles = hingeAngles(assembly, positions);
	Eigen::VectorXd bent = angles - anglesBefore;
	for (double& angle : bent)
		angle = std::remainder(angle, 2 * pi);
	const auto flipped = (anglesBefore.array().abs() < pi / 2 && angles.array().abs() > 2 * pi / 3).count();
	const auto smallest = [&](const Positions& p) {
		return std::atan2(1.0, cornerCotangents(assembly, p).maxCoeff()) * 180 / pi;
	};
	std::cout << original.cols() << ' ' << before.totalAbsoluteCurvature << ' '
			  << after.totalAbsoluteCurvature << ' ' << after.detectFunction / before.detectFunction << ' '
			  << after.maxAngleDefect << ' ' << displacement.mean() << ' ' << displacement.maxCoeff() << ' '
			  << distance.mean() << ' ' << distance.maxCoeff() << ' '
			  << bent.norm() / std::sqrt(double(bent.size())) * 180 / pi << ' ' << smallest(original) << ' '
			  << smallest(positions) << ' ' << flipped << ' ' << flattenedStrain(assembly, positions) << '\n';
}

/// Of this program alone; what getrusage tells includes the one that started it.
double peakMegabytes() {
	std::ifstream status("/proc/self/status");
	for (std::string line; std::getline(status, line);)
		if (line.rfind("VmHWM:", 0) == 0)
			return std::stod(line.substr(6)) / 1024;
	return 0;
}

/// After a quarter, half and three quarters of the processor time that a run takes: how much longer, as a
/// factor, the run was said to take as a whole than it took.
void printEstimates(const PatchAssembly& assembly) {
	Positions positions = assembly.originalPositions;
	std::vector<std::pair<std::clock_t, double>> said;
	ConstrainedNewtonOptions options;
	options.threads = 1;
	const std::clock_t start = std::clock();
	constrainedNewton(assembly, positions, options, [&](double fractionDone, const std::string&) {
		said.emplace_back(std::clock() - start, fractionDone);
		return true;
	});
	const double whole = double(std::clock() - start);
	std::cout << whole / CLOCKS_PER_SEC;
	for (const double share : {0.25, 0.5, 0.75}) {
		double fraction = 0;
		for (const auto& [time, fractionDone] : said)
			if (double(time) <= share * whole)
				fraction = fractionDone;
		std::cout << ' ' << share / fraction;
	}
	std::cout << '\n';
}

int run(const std::vector<std::string>& words) {
	if (words.size() == 5 && words[0] == "shape") {
		const TriangleMesh mesh = shape(words[1], std::stoi(words[2]), std::stod(words[3]));
		writeOff(words[4], mesh.positions, mesh.triangles);
	} else if (words.size() >= 4 && words.size() % 2 == 0 && words[0] == "run") {
		const TriangleMesh mesh = readOff(words[2]);
		const auto start = std::chrono::steady_clock::now();
		const PatchAssembly assembly = assemblePatches(mesh, {});
		Positions positions = assembly.originalPositions;
		const std::string status = runMethod(words[1], assembly, positions, {words.begin() + 4, words.end()});
		const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
		Positions vertices = mesh.positions;
		for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
			if (assembly.placeOfVertex[vertex] >= 0)
				vertices.col(vertex) = positions.col(assembly.placeOfVertex[vertex]);
		writeOff(words[3], vertices, mesh.triangles);
		std::cout << seconds.count() << ' ' << peakMegabytes() << ' ' << status << '\n';
	} else if (words.size() == 2 && words[0] == "estimates") {
		printEstimates(assemblePatches(readOff(words[1]), {}));
	} else if (words.size() == 3 && words[0] == "measure") {
		const PatchAssembly assembly = assemblePatches(readOff(words[1]), {});
		const TriangleMesh after = readOff(words[2]);
		Positions positions = assembly.originalPositions;
		for (int vertex = 0; vertex < after.vertexCount(); ++vertex)
			if (assembly.placeOfVertex[vertex] >= 0)
				positions.col(assembly.placeOfVertex[vertex]) = after.positions.col(vertex);
		printMeasures(assembly, positions);
	} else if (words.size() == 1 && words[0] == "constants") {
		for (const TuningConstant& constant : tuningConstants())
			std::cout << constant.name << ' ' << constant.value({}) << '\n';
	} else {
		std::cerr << "usage: shape NAME COLUMNS NOISE OUT | run METHOD IN OUT [CONSTANT FACTOR]... | "
					 "measure BEFORE AFTER | estimates IN | constants\n";
		return 2;
	}
	return 0;
}

} // namespace

int main(int count, char** words) {
	try {
		return run({words + 1, words + count});
	} catch (const std::exception& error) {
		std::cerr << error.what() << '\n';
		return 1;
	}
}
