// SPDX-License-Identifier: GPL-3.0-or-later
// material_verdict.cpp: the verdict in words and numbers.
#include "material_verdict.h"

#include "materials.h"

namespace developable::plugin {

namespace {

constexpr double perCent = 100;

/// "2 %", "2 % stretch and 1 % compression", or with its directions "1.9 % (warp), 1.9 % (weft), 4.7 %
/// (bias) stretch and ...".
std::string boundsInWords(const StrainBounds& bounds) {
	const auto one = [&](double DirectionBounds::*bound) {
		const auto number = [&](const DirectionBounds& direction) {
			return formatted(perCent * direction.*bound, 3) + " %";
		};
		if (!bounds.directed)
			return number(bounds.warp);
		return number(bounds.warp) + " (warp), " + number(bounds.weft) + " (weft), " + number(bounds.bias) +
			   " (bias)";
	};
	return one(&DirectionBounds::stretch) + " stretch and " + one(&DirectionBounds::compression) +
		   " compression";
}

/// Where a map of the pattern is largest on the model.
std::string placeOfLargest(const FlatPatterns& patterns, const Positions& positions) {
	int vertex = 0;
	patterns.stretch.cwiseMax(patterns.compression).maxCoeff(&vertex);
	const auto at = positions.col(patterns.placeOfVertex[std::size_t(vertex)]);
	return "(" + formatted(at[0], 4) + ", " + formatted(at[1], 4) + ", " + formatted(at[2], 4) + ")";
}

std::string verdict(const Material& material, const FlatPatterns& patterns, const Positions& positions) {
	const FlattenReport& report = patterns.report;
	std::string words = material.name + ": ";
	const int beyond = static_cast<int>(
		std::count_if(patterns.pieces.begin(), patterns.pieces.end(),
					  [](const FlatPiece& piece) { return piece.beyondBounds > patternTolerance; }));
	if (beyond == 0)
		words += "every panel is within its " + boundsInWords(patterns.bounds);
	else
		words += counted(std::size_t(beyond), "panel is", "panels are") + " beyond " +
				 boundsInWords(patterns.bounds) + ", by up to " +
				 formatted(perCent * report.beyondBounds, 3) + " % of length";
	return words + "; largest " + formatted(perCent * std::max(report.maxStretch, report.maxCompression), 3) +
		   " % at " + placeOfLargest(patterns, positions);
}

} // namespace

void addStrains(Results& results, const FlattenReport& report) {
	results.push_back({"max_stretch", perCent * report.maxStretch, ""});
	results.push_back({"max_compression", perCent * report.maxCompression, ""});
}

void judgeMaterial(FilterCall& call, const PatchAssembly& assembly, const Positions& positions,
				   Results& results) {
	FlattenOptions options;
	options.bounds = strainBounds(call.values);
	options.grain = call.values.choice<Grain>("grain");
	try {
		const FlatPatterns patterns = flattenPatches(assembly, positions, options);
		addStrains(results, patterns.report);
		if (!options.bounds.any())
			return;
		call.log(verdict(chosenMaterial(call.values), patterns, positions));
		for (const std::string& note : patterns.report.notes)
			call.log(note);
	} catch (
		const Error&) { // it has handles or one side only; the optimisation has done its part all the same
		results.push_back({"max_stretch", -1.0, ""});
		results.push_back({"max_compression", -1.0, ""});
	}
}

void judgeBending(FilterCall& call, const PatchAssembly& assembly, const Positions& positions) {
	const double thickness = call.values.number("thickness");
	const Material& material = chosenMaterial(call.values);
	if (thickness == 0)
		return;
	if (!(material.elasticStrain > 0)) {
		call.log(material.name + ": bending is not judged, as no strain is known that its surface bears");
		return;
	}
	const Eigen::VectorXd radii = bendingRadii(assembly, positions);
	const double limit = leastBendingRadius(thickness, material.elasticStrain);
	int tightest = 0;
	const double least = radii.minCoeff(&tightest);
	const auto at = positions.col(tightest);
	call.log(material.name + ", " + formatted(thickness, 3) + " thick, bears radii down to " +
			 formatted(limit, 3) + ": " +
			 formatted(perCent * shareBelowRadius(assembly, positions, radii, limit), 3) +
			 " % of the area is bent more tightly; the smallest radius is " + formatted(least, 3) + ", at (" +
			 formatted(at[0], 4) + ", " + formatted(at[1], 4) + ", " + formatted(at[2], 4) + ")");
}

} // namespace developable::plugin
