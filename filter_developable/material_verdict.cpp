// SPDX-License-Identifier: GPL-3.0-or-later
// material_verdict.cpp: the verdict in words and numbers.
#include "material_verdict.h"

#include "departure.h"
#include "face_data.h"
#include "materials.h"

#include "developable/geometry/geometry.h"

#include <algorithm>

namespace developable::plugin {

namespace {

constexpr double perCent = 100;
constexpr std::size_t mostPanels = 5; ///< that a verdict names

/// "2 % stretch and 1 % compression", or where a sign's bounds differ "1.9 % (warp), 1.9 % (weft), 4.7 %
/// (bias) stretch and ...".
std::string boundsInWords(const StrainBounds& bounds) {
	const auto one = [&](double DirectionBounds::*bound) {
		const auto number = [&](const DirectionBounds& direction) {
			return formatted(perCent * direction.*bound, 3) + " %";
		};
		if (bounds.sameInEveryDirection(bound))
			return number(bounds.warp);
		return number(bounds.warp) + " (warp), " + number(bounds.weft) + " (weft), " + number(bounds.bias) +
			   " (bias)";
	};
	return one(&DirectionBounds::stretch) + " stretch and " + one(&DirectionBounds::compression) +
		   " compression";
}

std::string pointInWords(const Eigen::Vector3d& at) {
	return "(" + formatted(at[0], 4) + ", " + formatted(at[1], 4) + ", " + formatted(at[2], 4) + ")";
}

std::vector<PanelStrain> strainsOfPanels(const PatchAssembly& assembly, const FlatPatterns& patterns,
										 const Positions& positions) {
	std::vector<int> worstVertex(patterns.pieces.size(), -1);
	const Eigen::VectorXd strain = patterns.stretch.cwiseMax(patterns.compression);
	for (int vertex = 0; vertex < patterns.vertexCount(); ++vertex) {
		int& worst = worstVertex[std::size_t(patterns.pieceOfVertex[std::size_t(vertex)])];
		if (worst < 0 || strain[vertex] > strain[worst])
			worst = vertex;
	}
	std::vector<PanelStrain> strains;
	for (std::size_t i = 0; i < patterns.pieces.size(); ++i) {
		const FlatPiece& piece = patterns.pieces[i];
		const Eigen::Vector3d at =
			piece.beyondBounds > patternTolerance
				? barycentre(positions, assembly.trianglePlaces.col(piece.worstTriangle))
				: Eigen::Vector3d(positions.col(patterns.placeOfVertex[std::size_t(worstVertex[i])]));
		strains.push_back({piece.maxStretch, piece.maxCompression,
						   piece.beyondBounds > patternTolerance ? piece.beyondBounds : 0,
						   inMeshUnits(assembly.lengthExponent, at)});
	}
	return strains;
}

/// "panel 2 by 0.31 % at (1, 2, 3), panel 4 by ...", the worst first.
std::string panelsBeyond(const std::vector<std::size_t>& beyond, const std::vector<PanelStrain>& strains) {
	std::string words;
	for (std::size_t i = 0; i < std::min(beyond.size(), mostPanels); ++i)
		words += (i == 0 ? "panel " : ", panel ") + std::to_string(beyond[i]) + " by " +
				 formatted(perCent * strains[beyond[i]].beyondBounds, 3) + " % at " +
				 pointInWords(strains[beyond[i]].at);
	return beyond.size() > mostPanels ? words + ", and others by less" : words;
}

/// "Leather, 1.2 thick", by the thickness that was asked for, in the mesh's unit, or that of the table.
std::string materialInWords(const ParameterValues& values) {
	const Material material = chosenMaterial(values);
	const double asked = values.has("thickness") ? values.number("thickness") : 0;
	if (asked > 0)
		return material.name + ", " + formatted(asked, 3) + " thick";
	return material.thickness > 0 ? material.name + ", " + formatted(material.thickness, 3) + " mm"
								  : material.name;
}

/// "5.1 % between its directions at (1, 2, 3)": bounds that differ with the direction say nothing of others
/// than these.
std::string largestInWords(const StrainBounds& bounds, const std::vector<PanelStrain>& strains) {
	const auto greatest = [](const PanelStrain& panel) { return std::max(panel.stretch, panel.compression); };
	const PanelStrain& largest =
		*std::max_element(strains.begin(), strains.end(), [&](const PanelStrain& a, const PanelStrain& b) {
			return greatest(a) < greatest(b);
		});
	const auto bound =
		largest.stretch < largest.compression ? &DirectionBounds::compression : &DirectionBounds::stretch;
	const double allowed = std::max({bounds.warp.*bound, bounds.weft.*bound, bounds.bias.*bound});
	const bool between = largest.beyondBounds == 0 && greatest(largest) > allowed + patternTolerance;
	return formatted(perCent * greatest(largest), 3) +
		   (between ? " % between its directions at " : " % at ") + pointInWords(largest.at);
}

std::string verdict(const std::string& material, const StrainBounds& bounds,
					const std::vector<PanelStrain>& strains) {
	std::vector<std::size_t> beyond;
	for (std::size_t i = 0; i < strains.size(); ++i)
		if (strains[i].beyondBounds > 0)
			beyond.push_back(i);
	std::stable_sort(beyond.begin(), beyond.end(), [&](std::size_t a, std::size_t b) {
		return strains[a].beyondBounds > strains[b].beyondBounds;
	});
	std::string words = material + ": ";
	if (beyond.empty())
		words += "every panel is within its " + boundsInWords(bounds);
	else
		words += counted(beyond.size(), "panel is", "panels are") + " beyond " + boundsInWords(bounds) +
				 ": " + panelsBeyond(beyond, strains);
	return words + "; largest " + largestInWords(bounds, strains);
}

} // namespace

void addStrains(Results& results, const FlattenReport& report) {
	results.push_back({"max_stretch", perCent * report.maxStretch, ""});
	results.push_back({"max_compression", perCent * report.maxCompression, ""});
}

std::vector<PanelStrain> judgeMaterial(FilterCall& call, const PatchAssembly& assembly,
									   const Positions& positions, const KnownPatterns& known,
									   Results& results) {
	constexpr int enough = 30; // steps: a shape that takes more folds, and its strain says so by then
	FlattenOptions options;
	options.bounds = strainBounds(call.values);
	options.grain = chosenGrain(call.values);
	if (!options.bounds.any())
		options.iterations = enough;
	try {
		const bool isKnown = known.shape.cols() == positions.cols() && known.shape == positions;
		const FlatPatterns patterns = isKnown ? known.patterns : flattenPatches(assembly, positions, options);
		addStrains(results, patterns.report);
		results.push_back({"collapsed_faces", patterns.report.collapsedFaces, ""});
		logWarnings(call, {results.back()});
		std::vector<PanelStrain> strains = strainsOfPanels(assembly, patterns, positions);
		if (options.bounds.any()) {
			call.log(verdict(materialInWords(call.values), patterns.bounds, strains));
			for (const std::string& note : patterns.report.notes)
				call.log(note);
		}
		return strains;
	} catch (
		const Error&) { // it has handles or one side only; the optimisation has done its part all the same
		results.push_back({"max_stretch", -1.0, ""});
		results.push_back({"max_compression", -1.0, ""});
		results.push_back({"collapsed_faces", -1, ""});
		return {};
	}
}

void writeStrains(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<PanelStrain>& strains) {
	const auto write = [&](const char* name, double PanelStrain::*strain) {
		Eigen::VectorXd values(strains.size());
		for (std::size_t i = 0; i < strains.size(); ++i)
			values[Eigen::Index(i)] = perCent * strains[i].*strain;
		writeFaceScalars(mesh, name, assembly, values);
	};
	write("panel_stretch", &PanelStrain::stretch);
	write("panel_compression", &PanelStrain::compression);
	write("panel_beyond_bounds", &PanelStrain::beyondBounds);
	Positions points(3, strains.size());
	for (std::size_t i = 0; i < strains.size(); ++i)
		points.col(Eigen::Index(i)) = strains[i].at;
	writeFacePoints(mesh, "panel_strain_point", assembly, points);
}

void judgeBending(FilterCall& call, const PatchAssembly& assembly, const Positions& positions) {
	const double thickness = call.values.number("thickness");
	if (thickness == 0)
		return;
	const Material material = chosenMaterial(call.values);
	if (!(material.elasticStrain > 0)) {
		call.log(material.name + ": bending is not judged, as no strain is known that its surface bears");
		return;
	}
	const Eigen::VectorXd radii = bendingRadii(assembly, positions);
	const int exponent = assembly.lengthExponent;
	const double limit = leastBendingRadius(inWorkingUnits(exponent, thickness), material.elasticStrain);
	int tightest = 0;
	const double least = radii.minCoeff(&tightest);
	call.log(materialInWords(call.values) + ", bears radii down to " +
			 formatted(inMeshUnits(exponent, limit), 3) + ": " +
			 formatted(perCent * shareBelowRadius(assembly, positions, radii, limit), 3) +
			 " % of the area is bent more tightly; the smallest radius is " +
			 formatted(inMeshUnits(exponent, least), 3) + ", at " +
			 pointInWords(inMeshUnits(exponent, positions.col(tightest))));
}

} // namespace developable::plugin
