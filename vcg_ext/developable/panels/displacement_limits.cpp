// SPDX-License-Identifier: GPL-3.0-or-later
// displacement_limits.cpp: parts, and the smallest box round each.
#include "displacement_limits.h"

#include "smallest_box.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace developable::detail {

namespace {

constexpr double defaultDisplacement = 0.02; ///< of the diagonal of a part

/// Lengths that should be equal become so to the last bit.
double withoutLastDigits(double length) {
	constexpr double parts = 0x1p26;
	int exponent = 0;
	const double mantissa = std::frexp(length, &exponent);
	return std::ldexp(std::round(mantissa * parts) / parts, exponent);
}

/// No more than along the axes of what was given, where people may look it up.
double sizeOf(const CanonicalForm& form, const Positions& points) {
	constexpr double equal = 1e-6;
	const double smallest = smallestBoxDiagonal(points);
	const double given = boxDiagonal(form.alongGivenAxes(points));
	return given < (1 - equal) * smallest ? given : smallest;
}

/// Per patch, from the size of the places of its part.
template <class Size>
std::vector<double> defaultLimits(const PatchAssembly& assembly, const Size& sizeOfPlaces) {
	DisjointSets parts(assembly.placeCount() + assembly.patchCount());
	for (int copy = 0; copy < assembly.copyCount(); ++copy)
		parts.unite(assembly.placeOfCopy[copy], assembly.placeCount() + assembly.patchOfCopy[copy]);
	std::map<int, std::vector<int>> places;
	for (int place = 0; place < assembly.placeCount(); ++place)
		places[parts.find(place)].push_back(place);
	std::map<int, double> limits;
	for (const auto& [part, own] : places)
		limits[part] =
			defaultDisplacement * sizeOfPlaces(Positions(assembly.originalPositions(Eigen::all, own)));
	std::vector<double> result;
	result.reserve(assembly.patchCount());
	for (int patch = 0; patch < assembly.patchCount(); ++patch)
		result.push_back(limits.at(parts.find(assembly.placeCount() + patch)));
	return result;
}

} // namespace

std::vector<double> displacementLimits(const CanonicalForm& form, double maxDisplacement) {
	const PatchAssembly assembly = assemblePatches(form.patches().mesh, {});
	std::vector<double> limits =
		maxDisplacement >= 0
			? std::vector<double>(assembly.patchCount(), form.inForm(maxDisplacement))
			: defaultLimits(assembly, [&](const Positions& points) { return sizeOf(form, points); });
	std::transform(limits.begin(), limits.end(), limits.begin(), withoutLastDigits);
	return limits;
}

std::vector<double> displacementLimits(const PatchAssembly& assembly, double maxDisplacement) {
	if (maxDisplacement >= 0)
		return std::vector<double>(assembly.patchCount(), maxDisplacement);
	return defaultLimits(assembly, [](const Positions& points) { return boxDiagonal(points); });
}

} // namespace developable::detail
