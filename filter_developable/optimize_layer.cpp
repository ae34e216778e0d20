// SPDX-License-Identifier: GPL-3.0-or-later
// optimize_layer.cpp: read, optimise, round, measure, write back once.
#include "optimize_layer.h"

#include "departure.h"
#include "layer.h"
#include "map_output.h"
#include "panel_output.h"
#include "practical_notes.h"
#include "shared_parameters.h"
#include "vertex_data.h"

#include "developable/geometry/geometry.h"
#include "developable/vcg_mesh/vcg_mesh.h"

#include <chrono>

namespace developable::plugin {

namespace {

constexpr double smallStrain = 3; ///< per cent of an edge: what many a material gives

/// Why the run ended, in numbers.
void addReason(Results& results, const OptimizationReport& report) {
	const auto [x, y, z] = report.worstPosition;
	results.push_back({"reason", static_cast<int>(report.reason), ""});
	results.push_back({"patches_needing_cut", report.patchesNeedingCut, ""});
	results.push_back({"nearest_developable", report.nearestDevelopable, ""});
	results.push_back({"border_overlaps", report.borderOverlaps, ""});
	results.push_back({"worst_x", x, ""});
	results.push_back({"worst_y", y, ""});
	results.push_back({"worst_z", z, ""});
}

/// What the log says of the status: never D without C, as D says little on fine meshes.
std::string statusInWords(const OptimizationReport& report, const std::string& reason, const Measures& before,
						  const Measures& after, double angleTolerance) {
	std::string words = reason + "; D: " + formatted(100 * after.developability, 4) +
						" % of the area is developable within " + formatted(angleTolerance, 4) +
						" rad; C: " + formatted(after.totalAbsoluteCurvature, 4) +
						" rad of total absolute curvature is left of " +
						formatted(before.totalAbsoluteCurvature, 4);
	// A flattened panel is strained by up to a third of C: beyond a thousandth that shows.
	if (converged(report.status) && report.reason != Reason::WithinBounds &&
		after.totalAbsoluteCurvature > 3e-3)
		words += "; every vertex passes, but they add up: lower angle_tolerance to come nearer to a "
				 "developable shape";
	return words;
}

void addPanels(Results& results, const std::vector<PanelReport>& panels) {
	results.push_back({"panels_converged",
					   countPanels(panels, Status::Converged) + countPanels(panels, Status::NothingToDo),
					   ""});
	results.push_back({"panels_need_cut", countPanels(panels, Status::NeedsCut), ""});
}

void addMeasures(Results& results, const Measures& before, const Measures& after) {
	results.push_back({"developability_before", before.developability, ""});
	results.push_back({"developability_after", after.developability, ""});
	results.push_back({"detect_function_before", before.detectFunction, ""});
	results.push_back({"detect_function_after", after.detectFunction, ""});
	results.push_back({"max_angle_defect_before", before.maxAngleDefect, ""});
	results.push_back({"max_angle_defect_after", after.maxAngleDefect, ""});
	results.push_back({"total_absolute_curvature_before", before.totalAbsoluteCurvature, ""});
	results.push_back({"total_absolute_curvature_after", after.totalAbsoluteCurvature, ""});
}

/// What the method says of lengths, in the mesh's own unit.
void toMeshUnits(const PatchAssembly& assembly, OptimizationReport& report) {
	const auto inUnits = [&](double& length) { length = inMeshUnits(assembly.lengthExponent, length); };
	for (double& coordinate : report.worstPosition)
		inUnits(coordinate);
	inUnits(report.nearestDevelopable);
	for (PatchVerdict& verdict : report.patchVerdicts)
		inUnits(verdict.nearestDevelopable);
}

void addChanges(Results& results, const PatchAssembly& assembly, const Positions& positions) {
	const Positions& original = assembly.originalPositions;
	const Eigen::VectorXd displacements = displacementMap(original, positions);
	const Eigen::VectorXd distances = distancesToSurface(positions, original, assembly.trianglePlaces);
	const double energy = elasticEnergy(assembly, positions, edgeLengths(assembly, original));
	const auto inUnits = [&](double value, int lengthPower) {
		return inMeshUnits(assembly.lengthExponent, value, lengthPower);
	};
	results.push_back({"patches", assembly.patchCount(), ""});
	results.push_back({"assembling_vertices", assembly.assemblingPlaceCount(), ""});
	results.push_back({"interior_vertices", assembly.interiorCopyCount(), ""});
	results.push_back({"deformation_energy", inUnits(energy, 2), ""});
	results.push_back({"max_displacement", inUnits(displacements.maxCoeff(), 1), ""});
	results.push_back({"max_displacement_per_cent", farthestInPerCent(assembly, positions), ""});
	results.push_back({"mean_displacement", inUnits(displacements.mean(), 1), ""});
	results.push_back({"max_distance", inUnits(distances.maxCoeff(), 1), ""});
}

void write(FilterCall& call, const PatchAssembly& assembly, const Positions& positions,
		   const std::vector<PanelReport>& panels) {
	const Map map = chosenMap(call.values);
	const Eigen::VectorXd values = mapValues(map, assembly, positions, assembly.originalPositions);
	CMeshO& mesh = call.layer.mesh();
	writePointAttribute(mesh, "original_position", assembly, assembly.originalPositions);
	writePositions(mesh, assembly, positions);
	call.layer.positionsChanged();
	writeMap(call, assembly, map, values);
	showMap(call, assembly, map, values);
	writePanels(mesh, assembly, panels);
}

} // namespace

Optimized optimizeLayer(FilterCall& call, const Method& method) {
	const auto start = std::chrono::steady_clock::now();
	chosenMap(call.values); // a map that does not work is better refused before a long run
	const double angleTolerance = call.values.number("angle_tolerance");
	Optimized result;
	result.assembly = readPatches(call.layer.mesh(), patchOptions(call.values));
	const PatchAssembly& assembly = result.assembly;
	requireOpenPatches(assembly);

	result.positions = assembly.originalPositions;
	OptimizationReport report = method(assembly, result.positions, call.progress);
	toMeshUnits(assembly, report);
	const Measures before = measure(assembly, assembly.originalPositions, angleTolerance);
	const Measures unrounded = measure(assembly, result.positions, angleTolerance);
	if (report.status != Status::Stopped)
		result.positions = rounded<host::Scalar>(result.positions, assembly.lengthExponent);
	const Measures after = measure(assembly, result.positions, angleTolerance);

	Results& results = result.results;
	addMeasures(results, before, after);
	results.push_back({"total_absolute_curvature_before_rounding", unrounded.totalAbsoluteCurvature, ""});
	addChanges(results, assembly, result.positions);
	results.push_back({"iterations", static_cast<int>(report.iterations), ""});
	results.push_back({"converged", converged(report.status), ""});
	const std::vector<PanelReport> panels = panelReports(assembly, result.positions, report, angleTolerance);
	addPanels(results, panels);
	const std::optional<double> strain = strainLeft(assembly, result.positions, panels);
	if (report.reason == Reason::NeedsCut && strain && *strain < smallStrain)
		report.reason = Reason::NearlyThere;
	results.push_back({"edge_strain_left", strain.value_or(0), ""});
	addReason(results, report);
	const std::string reason = reasonInWords(report.status, report.reason, results);
	results.push_back({"status", static_cast<int>(report.status),
					   statusInWords(report, reason, before, after, angleTolerance)});
	call.verdict(reason +
				 filledIn("; {total_absolute_curvature_after} of "
						  "{total_absolute_curvature_before} rad of curvature left, moved by at most "
						  "{max_displacement} units of the mesh",
						  results));
	logPanels(call, panels);
	result.stopped = report.status == Status::Stopped;
	if (!result.stopped) {
		logDepartures(call, results, assembly, result.positions);
		write(call, assembly, result.positions, panels);
		call.log(
			"way back: MeshLab does not undo filters, but the filter Restore Original Shape takes this one back");
	}
	const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
	results.push_back({"seconds", elapsed.count(), ""});
	return result;
}

} // namespace developable::plugin
