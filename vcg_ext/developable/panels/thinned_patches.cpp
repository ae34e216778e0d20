// SPDX-License-Identifier: GPL-3.0-or-later
// thinned_patches.cpp: a coarse level as a mesh of its own, and the way back.
#include "thinned_patches.h"

#include "cut_sides.h"
#include "selected_whole.h"
#include "slit_labels.h"

#include "developable/newton/constrained_newton.h"

#include <numeric>

namespace developable::detail {

namespace {

Positions barycentresOf(const TriangleMesh& mesh, const std::vector<int>& triangles) {
	Positions middles(3, triangles.size());
	for (std::size_t i = 0; i < triangles.size(); ++i)
		middles.col(i) = barycentre(mesh.positions, mesh.triangles.col(triangles[i]));
	return middles;
}

TriangleMesh meshOf(const PatchAssembly& assembly, const TriangleMesh& given) {
	TriangleMesh mesh;
	mesh.positions = assembly.originalPositions(Eigen::all, assembly.placeOfCopy);
	mesh.triangles = assembly.triangleCopies;
	mesh.vertexSelected.assign(mesh.vertexCount(), 0);
	mesh.leastHeightRatio = given.leastHeightRatio;
	mesh.lengthExponent = given.lengthExponent;
	std::vector<int> all(mesh.triangleCount());
	std::iota(all.begin(), all.end(), 0);
	for (const int nearest : nearestTriangles(barycentresOf(mesh, all), given.positions, given.triangles))
		mesh.triangleSelected.push_back(given.triangleSelected[nearest]);
	return mesh;
}

/// Per patch.
std::vector<std::vector<int>> trianglesOfPatches(const std::vector<int>& patchOfTriangle, int patches) {
	std::vector<std::vector<int>> triangles(patches);
	for (std::size_t t = 0; t < patchOfTriangle.size(); ++t)
		triangles[patchOfTriangle[t]].push_back(static_cast<int>(t));
	return triangles;
}

} // namespace

ThinnedPatches::ThinnedPatches(const GivenPatches& given, int places)
	: given_(given), assembly_(assemblePatches(given.mesh, {})) {
	const PartialAssembly coarse = coarserLevel(assembly_, places);
	thin_.mesh = meshOf(coarse.assembly, given.mesh);
	numberByThemselves(thin_);
	thin_.seamLength = given.seamLength;
	for (const int patch : coarse.assembly.patchOfTriangle)
		patchGiven_.push_back(coarse.wholePatch[patch]);
}

std::vector<double> ThinnedPatches::limits(const std::vector<double>& ofGiven) const {
	const PatchAssembly assembly = assemblePatches(thin_.mesh, {});
	std::vector<double> limits(assembly.patchCount());
	for (int t = 0; t < assembly.triangleCount(); ++t)
		limits[assembly.patchOfTriangle[t]] = ofGiven[patchGiven_[assembly.faceOfTriangle[t]]];
	return limits;
}

/// Per triangle of what was given, within its patch.
std::vector<int> ThinnedPatches::nearestLabels(const PlannedSurface& planned,
											   const std::vector<int>& labels) const {
	std::vector<int> patchOfPart;
	for (const int face : planned.mesh.face)
		patchOfPart.push_back(patchGiven_[face]);
	const auto here = trianglesOfPatches(patchOfPart, assembly_.patchCount());
	const auto given = trianglesOfPatches(assembly_.patchOfTriangle, assembly_.patchCount());
	std::vector<int> result(assembly_.triangleCount(), 0);
	for (int patch = 0; patch < assembly_.patchCount(); ++patch) {
		const Eigen::Matrix3Xi triangles = planned.mesh.triangles(Eigen::all, here[patch]);
		const std::vector<int> nearest =
			nearestTriangles(barycentresOf(given_.mesh, given[patch]), planned.mesh.positions, triangles);
		for (std::size_t i = 0; i < nearest.size(); ++i)
			result[given[patch][i]] = labels[here[patch][nearest[i]]];
	}
	return result;
}

CarriedPanels ThinnedPatches::carriedBack(const PlannedSurface& planned, const CutOptions& options) const {
	PlannedSurface result{given_.mesh, given_.origins, CutSurface(assembly_)};
	const SlitLabels slits(planned.surface, cutSides(planned.surface));
	std::vector<int> labels = result.surface.withoutFragments(
		withSelectedWhole(result, options, nearestLabels(planned, slits.labels())));
	result.surface.relabel(labels);
	slits.openWithin(result.surface, labels);
	return {std::move(result), std::move(labels)};
}

} // namespace developable::detail
