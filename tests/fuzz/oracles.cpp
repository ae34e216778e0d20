// SPDX-License-Identifier: GPL-3.0-or-later
// oracles.cpp: angles by the arc tangent, normals by the cross product, and counting.
#include "oracles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace developable::fuzz {

namespace {

/// The angle at a corner of a triangle, and what rounding may make of it where it is taken from twice the
/// area, which is known up to a share of the square of the longest edge.
struct Angle {
	double value, error;
};

Angle angleAt(const PatchAssembly& assembly, const Positions& positions, int triangle, int corner) {
	const auto places = assembly.trianglePlaces.col(triangle);
	const Eigen::Vector3d at = positions.col(places[corner]);
	const Eigen::Vector3d a = positions.col(places[(corner + 1) % 3]) - at;
	const Eigen::Vector3d b = positions.col(places[(corner + 2) % 3]) - at;
	const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
	const Eigen::Vector3d u = a / longest, v = b / longest;
	return {std::atan2(u.cross(v).norm(), u.dot(v)), 1e-14 / (u.norm() * v.norm()) + 1e-14};
}

Eigen::Vector3d normalOf(const PatchAssembly& assembly, const Positions& positions, int triangle) {
	const auto places = assembly.trianglePlaces.col(triangle);
	const Eigen::Vector3d a = positions.col(places[1]) - positions.col(places[0]);
	const Eigen::Vector3d b = positions.col(places[2]) - positions.col(places[0]);
	const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
	return (a / longest).cross(b / longest); // its length: of a triangle with longest edge 1, twice the area
}

void checkNeighbours(const PatchAssembly& assembly, Findings& findings) {
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int across = assembly.joinedHalfEdge[h];
		if (across < 0)
			continue;
		const int next = h % 3 == 2 ? h - 2 : h + 1, nextAcross = across % 3 == 2 ? across - 2 : across + 1;
		findings.expect(across != h && assembly.joinedHalfEdge[across] == h,
						"a neighbour does not know its own");
		findings.expect(assembly.patchOfTriangle[h / 3] == assembly.patchOfTriangle[across / 3],
						"neighbours in two patches");
		findings.expect(std::minmax(assembly.copyAt(h), assembly.copyAt(next)) ==
							std::minmax(assembly.copyAt(across), assembly.copyAt(nextAcross)),
						"neighbours without common vertex copies");
	}
}

void checkCopies(const PatchAssembly& assembly, const PatchOptions& options, Findings& findings) {
	std::vector<char> interior(assembly.copyCount(), 1);
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		const int copy = assembly.copyAt(h), next = assembly.copyAt(h % 3 == 2 ? h - 2 : h + 1);
		findings.expect(assembly.placeOfCopy[copy] == assembly.placeAt(h), "a corner in two places");
		findings.expect(assembly.patchOfCopy[copy] == assembly.patchOfTriangle[h / 3],
						"a corner in two patches");
		if (assembly.joinedHalfEdge[h] < 0)
			interior[copy] = interior[next] = 0;
	}
	for (int copy = 0; copy < assembly.copyCount(); ++copy) {
		findings.expect(bool(assembly.copyInterior[copy]) == bool(interior[copy]),
						"inside and outside are mistaken");
		findings.expect(interior[copy] || !options.fixBoundary ||
							assembly.placeFixed[assembly.placeOfCopy[copy]],
						"a vertex on the boundary is not held");
	}
}

void checkPlaces(const TriangleMesh& mesh, const PatchOptions& options, const PatchAssembly& assembly,
				 Findings& findings) {
	using Point = std::array<double, 3>;
	std::map<Point, int> placeOfPoint;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
		const int place = assembly.placeOfVertex[vertex];
		if (place < 0)
			continue;
		findings.expect(place < assembly.placeCount(), "a place out of range");
		const Point point = {mesh.positions(0, vertex), mesh.positions(1, vertex), mesh.positions(2, vertex)};
		findings.expect(placeOfPoint.emplace(point, place).first->second == place,
						"vertices with equal coordinates in two places");
		findings.expect(!options.fixSelected || !mesh.vertexSelected[vertex] || assembly.placeFixed[place],
						"a selected vertex is not held");
		findings.expect(options.weldDistance > 0 ||
							assembly.originalPositions.col(place) == mesh.positions.col(vertex),
						"a vertex has moved though nothing is welded");
	}
}

/// Numbers of vertices with coordinates that are none.
std::vector<int> verticesNowhere(const TriangleMesh& mesh) {
	std::vector<int> found;
	for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
		if (!std::isfinite(mesh.positions.col(vertex).sum()))
			found.push_back(vertex);
	return found;
}

/// Numbers of faces that are lower than so many times the least share of their longest edge.
std::vector<int> facesThinnerThan(const TriangleMesh& mesh, double times) {
	std::vector<int> found;
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const auto corner = [&](int i) { return mesh.positions.col(mesh.triangles(i % 3, t)); };
		double longest = 0;
		for (int i = 0; i < 3; ++i)
			longest = std::max(longest, (corner(i + 1) - corner(i)).norm());
		const Eigen::Vector3d a = (corner(1) - corner(0)) / longest, b = (corner(2) - corner(0)) / longest;
		if (!(a.cross(b).norm() > times * mesh.leastHeightRatio))
			found.push_back(mesh.face[t]);
	}
	return found;
}

/// The number behind some words of a sentence, or at its beginning; -1 when it has not got them.
int numberIn(const std::string& sentence, const std::string& words) {
	const std::size_t found = sentence.find(words);
	return found == std::string::npos ? -1 : std::atoi(sentence.c_str() + found + words.size());
}

bool among(const std::vector<int>& numbers, int number) {
	return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

void checkBlameOfCoordinates(const TriangleMesh& mesh, const std::string& sentence, Findings& findings) {
	const std::vector<int> nowhere = verticesNowhere(mesh);
	findings.expect(numberIn(sentence, "") == int(nowhere.size()) &&
						among(nowhere, numberIn(sentence, "See vertex ")),
					"not true of " + std::to_string(nowhere.size()) + " vertices: " + sentence);
}

/// Where rounding decides about a triangle, both are true.
void checkBlameOfTriangles(const TriangleMesh& mesh, const std::string& sentence, Findings& findings) {
	const std::vector<int> surely = facesThinnerThan(mesh, 1 - 1e-3),
						   perhaps = facesThinnerThan(mesh, 1 + 1e-3);
	const int said = numberIn(sentence, "");
	findings.expect(said >= int(surely.size()) && said <= int(perhaps.size()) &&
						among(perhaps, numberIn(sentence, "See face ")),
					"not true of " + std::to_string(surely.size()) + " faces: " + sentence);
}

} // namespace

bool assembleAndCheck(const TriangleMesh& mesh, const PatchOptions& options, PatchAssembly& assembly,
					  Findings& findings) {
	const bool facesAsTheyAre = options.weldDistance == 0 && !options.onlySelected;
	return attempt(
		[&] {
			try {
				assembly = assemblePatches(mesh, options);
			} catch (const InvalidCoordinate& error) {
				checkBlameOfCoordinates(mesh, error.what(), findings);
				throw;
			} catch (const DegenerateTriangle& error) {
				if (facesAsTheyAre)
					checkBlameOfTriangles(mesh, error.what(), findings);
				throw;
			}
			findings.expect(verticesNowhere(mesh).empty(), "coordinates that are no numbers are not refused");
			findings.expect(!facesAsTheyAre || facesThinnerThan(mesh, 1 - 1e-3).empty(),
							"thin faces are not refused");
			checkAssembly(mesh, options, assembly, findings);
		},
		findings);
}

OwnDefects ownDefects(const PatchAssembly& assembly, const Positions& positions, AtBorders atBorders) {
	OwnDefects defects{Eigen::VectorXd::Constant(assembly.copyCount(), 2 * pi),
					   Eigen::VectorXd::Constant(assembly.copyCount(), 1e-14)};
	for (int corner = 0; corner < 3 * assembly.triangleCount(); ++corner) {
		const auto [angle, error] = angleAt(assembly, positions, corner / 3, corner % 3);
		defects.values[assembly.copyAt(corner)] -= angle;
		defects.errors[assembly.copyAt(corner)] += error;
	}
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		if (!assembly.copyInterior[copy] && (atBorders == AtBorders::Nothing || defects.values[copy] > 0))
			defects.values[copy] = defects.errors[copy] = 0;
	return defects;
}

std::vector<double> ownPatchCurvatures(const PatchAssembly& assembly, const OwnDefects& defects) {
	std::vector<double> curvatures(assembly.patchCount(), 0);
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		curvatures[assembly.patchOfCopy[copy]] += std::abs(defects.values[copy]);
	return curvatures;
}

void checkAssembly(const TriangleMesh& mesh, const PatchOptions& options, const PatchAssembly& assembly,
				   Findings& findings) {
	findings.expect(assembly.originalPositions.allFinite(), "places that are not finite");
	findings.expect(assembly.triangleCount() > 0 && assembly.triangleCount() <= mesh.triangleCount(),
					"a wrong number of triangles");
	checkNeighbours(assembly, findings);
	checkCopies(assembly, options, findings);
	checkPlaces(mesh, options, assembly, findings);
}

void checkResult(const PatchAssembly& assembly, const Positions& before, const Positions& after,
				 Findings& findings, AtBorders atBorders) {
	findings.expect(after.cols() == before.cols() && after.allFinite(), "positions that are not finite");
	for (int place = 0; place < assembly.placeCount(); ++place)
		findings.expect(!assembly.placeFixed[place] || after.col(place) == before.col(place),
						"a held vertex has moved");
	const OwnDefects start = ownDefects(assembly, before, atBorders),
					 end = ownDefects(assembly, after, atBorders);
	const double slack = start.detectError() + end.detectError();
	findings.expect(end.detectFunction() <= start.detectFunction() + slack,
					"G has risen from " + std::to_string(start.detectFunction()) + " to " +
						std::to_string(end.detectFunction()));
}

void checkTrianglesInOrder(const PatchAssembly& assembly, const Positions& after, Findings& findings) {
	// Of thinner triangles rounding makes the normal.
	constexpr double leastArea = 1e-8, slack = 1e-6;
	const Positions& before = assembly.originalPositions;
	double smallestBefore = pi, smallestAfter = pi;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		smallestBefore = std::min(smallestBefore, angleAt(assembly, before, h / 3, h % 3).value);
		smallestAfter = std::min(smallestAfter, angleAt(assembly, after, h / 3, h % 3).value);
		const int across = assembly.joinedHalfEdge[h];
		if (across < 0)
			continue;
		const double sameSide = assembly.copyAt(h) == assembly.copyAt(across) ? -1 : 1;
		const auto cosine = [&](const Positions& positions) {
			const Eigen::Vector3d a = normalOf(assembly, positions, h / 3),
								  b = normalOf(assembly, positions, across / 3);
			const bool thin = std::min(a.norm(), b.norm()) < leastArea;
			return thin ? std::nan("") : sameSide * a.normalized().dot(b.normalized());
		};
		findings.expect(!(cosine(before) > slack) || !(cosine(after) < -0.5 - slack),
						"a triangle has flipped");
	}
	findings.expect(smallestAfter >= std::min(smallestBefore / 2, 2 * pi / 180) * (1 - slack) - 1e-12,
					"a triangle has become a sliver");
}

} // namespace developable::fuzz
