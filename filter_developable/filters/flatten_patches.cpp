// SPDX-License-Identifier: GPL-3.0-or-later
// flatten_patches.cpp: the filter Flatten Patches.
#include "../map_output.h"
#include "../material_verdict.h"
#include "../materials.h"
#include "../pattern_layer.h"
#include "../shared_parameters.h"
#include "../vertex_data.h"
#include "filters.h"

#include "developable/flatten/flatten.h"
#include "developable/vcg_mesh/vcg_mesh.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace developable::plugin {

namespace {

constexpr double marginBeside = 0.05; ///< of the patterns' diagonal, between them and the model

/// The patterns as a mesh with the host's scalar holds them, measured again.
FlatPatterns roundedPatterns(FlatPatterns patterns, const PatchAssembly& assembly) {
	patterns.positions = rounded<host::Scalar>(patterns.positions, assembly.lengthExponent);
	measurePatterns(assembly, assembly.originalPositions, patterns);
	return patterns;
}

/// Moves the patterns along x until they are clear of the model, which they would go through otherwise.
void placeBeside(const CMeshO& model, const PatchAssembly& assembly, FlatPatterns& patterns) {
	double right = -std::numeric_limits<double>::infinity();
	for (const auto& vertex : model.vert)
		if (!vertex.IsD())
			right = std::max(right, double((model.Tr * vertex.cP())[0]));
	right = inWorkingUnits(assembly.lengthExponent, right);
	const Eigen::Vector2d low = patterns.positions.rowwise().minCoeff(),
						  size = patterns.positions.rowwise().maxCoeff() - low;
	patterns.positions.row(0).array() += right + marginBeside * size.norm() - low[0];
}

/// An assembly that says of a layer made by writePatterns only which vertex a value belongs to.
PatchAssembly verticesOf(const FlatPatterns& patterns, int lengthExponent) {
	PatchAssembly assembly;
	assembly.lengthExponent = lengthExponent;
	assembly.placeOfVertex.resize(std::size_t(patterns.vertexCount()));
	std::iota(assembly.placeOfVertex.begin(), assembly.placeOfVertex.end(), 0);
	return assembly;
}

/// Says of each vertex of the patterns which piece it is part of (from 0), where it is on the model, and
/// which place that is: what has the same place is sewn together.
void writePieces(Layer& patternLayer, const PatchAssembly& assembly, const FlatPatterns& patterns) {
	const PatchAssembly vertices = verticesOf(patterns, assembly.lengthExponent);
	const auto write = [&](const char* name, const std::vector<int>& numbers) {
		const Eigen::Map<const Eigen::VectorXi> values(numbers.data(), patterns.vertexCount());
		writeScalarAttribute(patternLayer.mesh(), name, vertices, values.cast<double>());
	};
	write("piece", patterns.pieceOfVertex);
	write("place", patterns.placeOfVertex);
	Positions onModel(3, patterns.vertexCount());
	for (int vertex = 0; vertex < patterns.vertexCount(); ++vertex)
		onModel.col(vertex) = assembly.originalPositions.col(patterns.placeOfVertex[std::size_t(vertex)]);
	writePointAttribute(patternLayer.mesh(), "model_position", vertices, onModel);
}

void logSeams(const FilterCall& call, int lengthExponent, const std::vector<Seam>& seams) {
	const auto shown = [=](double length, int digits) {
		return formatted(inMeshUnits(lengthExponent, length), digits);
	};
	constexpr std::size_t most = 100;
	for (std::size_t i = 0; i < std::min(seams.size(), most); ++i) {
		const Seam& seam = seams[i];
		call.log("seam " + std::to_string(i + 1) + ": piece " + std::to_string(seam.piece[0] + 1) + " with " +
				 std::to_string(seam.piece[1] + 1) + ", lengths " + shown(seam.length[0], 6) + " and " +
				 shown(seam.length[1], 6) + ", mismatch " + shown(seam.mismatch(), 3) + " (" +
				 formatted(100 * seam.ease(), 3) + " % of ease)");
	}
	if (seams.size() > most)
		call.log("and " + std::to_string(seams.size() - most) + " more seams");
}

/// Writes both maps to the model and to the patterns, and shows the chosen one on both.
void writeMaps(FilterCall& call, Layer& patternLayer, const PatchAssembly& assembly,
			   const FlatPatterns& patterns) {
	const std::pair<Map, const Eigen::VectorXd*> maps[] = {// as the parameter has them
														   {Map::EdgeStrain, &patterns.edgeStrain},
														   {Map::ElasticEnergy, &patterns.elasticEnergy},
														   {Map::Stretch, &patterns.stretch},
														   {Map::Compression, &patterns.compression}};
	FilterCall onPatterns{patternLayer, call.values, call.progress, [](const std::string&) {}, call.addLayer};
	const PatchAssembly patternVertices = verticesOf(patterns, assembly.lengthExponent);
	int number = 0;
	for (const auto& [map, values] : maps) {
		const Eigen::VectorXd placeValues = largestAtPlaces(assembly, patterns, *values);
		writeMap(call, assembly, map, placeValues);
		writeMap(onPatterns, patternVertices, map, *values);
		if (number++ != call.values.integer("map"))
			continue;
		showMap(call, assembly, map, placeValues);
		showMap(onPatterns, patternVertices, map, *values);
	}
}

Results runFlatten(FilterCall& call) {
	const auto start = std::chrono::steady_clock::now();
	const PatchAssembly assembly = readPatches(call.layer.mesh(), patchOptions(call.values));
	FlattenOptions options;
	options.gap = inWorkingUnits(assembly.lengthExponent, call.values.number("gap"));
	options.bounds = strainBounds(call.values);
	options.grain = chosenGrain(call.values);
	FlatPatterns patterns = flattenPatches(assembly, assembly.originalPositions, options, call.progress);
	if (patterns.report.stopped) {
		call.log("stopped by the user: nothing was changed");
	} else {
		placeBeside(call.layer.mesh(), assembly, patterns);
		patterns = roundedPatterns(std::move(patterns), assembly);
		if (call.values.boolean("write_texture_coordinates"))
			writeTextureCoordinates(call.layer, assembly, patterns);
		Layer patternLayer = call.addLayer(" pattern");
		writePatterns(patternLayer, patterns, assembly.lengthExponent);
		writePieces(patternLayer, assembly, patterns);
		writeSeams(patternLayer, patterns.seams);
		writeMaps(call, patternLayer, assembly, patterns);
		logSeams(call, assembly.lengthExponent, patterns.seams);
		for (const std::string& note : patterns.report.notes)
			call.log(note);
	}
	const FlattenReport& report = patterns.report;
	if (!report.stopped)
		call.verdict(std::to_string(report.pieces) + (report.pieces == 1 ? " piece" : " pieces") +
					 " laid flat; edges change by at most " + formatted(100 * report.maxEdgeStrain, 3) +
					 " % of their length" +
					 (report.overlappingPieces > 0
						  ? "; " + std::to_string(report.overlappingPieces) + " overlap"
						  : ""));
	const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
	Results results = {
		{"pieces", report.pieces, ""},
		{"max_edge_strain", report.maxEdgeStrain, ""},
		{"mean_edge_strain", report.meanEdgeStrain, ""},
		{"elastic_energy", inMeshUnits(assembly.lengthExponent, report.elasticEnergy, 2), ""},
		{"max_seam_mismatch", inMeshUnits(assembly.lengthExponent, report.maxSeamMismatch), ""},
		{"overlapping_pieces", report.overlappingPieces, ""},
		{"flipped_faces", report.flippedFaces, ""},
	};
	addStrains(results, report);
	results.push_back({"seconds", elapsed.count(), ""});
	return results;
}

} // namespace

FilterDescription patchFlattening() {
	FilterDescription filter;
	filter.name = "Flatten Patches";
	filter.pythonName = "generate_flat_patches";
	filter.shortName = "flatten";
	filter.filterClass = FilterClass::Texture;
	filter.change = Change::TextureCoordinates;
	filter.help =
		"Lays every panel of the layer flat, as a <b>pattern</b> to cut and sew: at the model's own scale, with "
		"edges as long as they are on the model, or as nearly so as can be. The pattern is a new layer beside "
		"the model, named after it; delete that to undo. Pieces show their outside and stand upright by their "
		"longest seam.<br><br>"
		"Holes stay open and are not filled. A panel is cut open only where it can't be flat otherwise, like a "
		"tube along its length. The log begins with how much edges change their length, the <b>edge strain</b>, "
		"says where a panel was cut, and gives the lengths of both sides of every seam. A panel that Global "
		"Developability has finished comes out with next to no strain. Closed surfaces must be cut first.<br><br>"
		"See: <i>C. C. L. Wang, K. Tang</i>, <b>Achieving developability of a polygonal surface by minimum "
		"deformation: a study of global and local optimization approaches</b>, The Visual Computer 20, 2004, "
		"Fig. 1; <i>R. Sawhney, K. Crane</i>, <b>Boundary First Flattening</b>, ACM Transactions on Graphics "
		"37, 2017, for where the flattening starts.";
	filter.parameters = {patchesParameter(), weldDistanceParameter(), onlySelectedParameter()};
	for (const Parameter& parameter : materialParameters())
		filter.parameters.push_back(parameter);
	const Parameter own[] = {
		automaticLength(
			"gap", "Room between pieces",
			"How far apart the pieces lie; -1 means 2 % of the diagonal of the largest piece's box. Any "
			"negative number means that."),
		enumeration(
			"map", {"Edge strain", "Elastic energy", "Stretch", "Compression"}, 0, "What is shown",
			"What is written to the vertex quality of the model and of the patterns. It is the greatest strain "
			"of the edges at a vertex, half of the energy of these edges (Fig. 1), or the greatest stretch or "
			"compression of the triangles at a vertex."),
		boolParameter(
			"write_texture_coordinates", false, "Write texture coordinates",
			"Write the patterns to the model too, as texture coordinates of its face corners, scaled "
			"to fit the unit square."),
		colorizeParameter(),
	};
	filter.parameters.insert(filter.parameters.end(), std::begin(own), std::end(own));
	filter.run = runFlatten;
	return filter;
}

} // namespace developable::plugin
