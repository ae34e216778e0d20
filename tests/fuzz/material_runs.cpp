// SPDX-License-Identifier: GPL-3.0-or-later
// material_runs.cpp: shapes and patterns of materials that give.
#include "runs.h"

#include "developable/bounded_strain/bounded_strain.h"
#include "developable/flatten/flatten.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace developable::fuzz {

namespace {

StrainBounds hostileBounds(Random& random) {
	const auto directions = [&] {
		return DirectionBounds{random.oneOf({0.0, 0.01, 0.1, 0.5}), random.oneOf({0.0, 0.01, 0.1})};
	};
	StrainBounds bounds;
	bounds.warp = directions();
	bounds.directed = random.chance(0.4);
	bounds.weft = bounds.directed ? directions() : bounds.warp;
	bounds.bias = bounds.directed ? directions() : bounds.warp;
	if (random.chance(0.05))
		bounds.bias.stretch = random.oneOf({-0.1, std::nan("")});
	return bounds;
}

/// A triangle's corners in a plane of its own, of which two are the first column and the second.
Eigen::Matrix2d sides(const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
	Eigen::Matrix2d result;
	const double along = b.dot(c) / b.norm();
	result << b.norm(), along, 0, (c - along * b.normalized()).norm();
	return result;
}

/// By how much a strain from pattern to shape is beyond bounds that hold in all directions, at most. What
/// collapses counts as stretched by 900 %.
double ownBeyond(const PatchAssembly& assembly, const Positions& shape, const FlatPatterns& patterns) {
	double beyond = 0;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const auto corner = [&](int i) { return shape.col(assembly.trianglePlaces(i, t)); };
		const auto flat = [&](int i) { return patterns.positions.col(patterns.triangles(i, t)); };
		Eigen::Matrix2d before;
		before << flat(1) - flat(0), flat(2) - flat(0);
		const Eigen::Matrix2d map = sides(corner(1) - corner(0), corner(2) - corner(0)) * before.inverse();
		const Eigen::Vector2d strains = map.jacobiSvd().singularValues();
		beyond = std::max({beyond, std::min(strains[0], 10.0) - 1 - patterns.bounds.warp.stretch,
						   1 - strains[1] - patterns.bounds.warp.compression});
	}
	return beyond;
}

/// That patterns are as far beyond their bounds as they say.
void checkBounds(const PatchAssembly& assembly, const Positions& shape, const FlatPatterns& patterns,
				 Findings& findings) {
	findings.expect(patterns.positions.allFinite(), "patterns that are not finite");
	if (patterns.bounds.directed || patterns.report.flippedFaces > 0)
		return;
	const double own = ownBeyond(assembly, shape, patterns), said = patterns.report.beyondBounds;
	findings.expect(!(std::abs(own - said) > 1e-6 * (1 + own)) || own > 1e6,
					"strains " + std::to_string(own) + " beyond their bounds, reported as " +
						std::to_string(said));
}

} // namespace

void runBoundedStrain(Random& random, const PatchAssembly& assembly, Findings& findings) {
	BoundedStrainOptions options;
	options.bounds = hostileBounds(random);
	options.grain = random.oneOf({Grain::LongestSeam, Grain::XAxis, Grain::ZAxis});
	options.maxIterations = random.below(12);
	options.smoothness = random.oneOf({3e-6, 1e-9, 1.0});
	int callsUntilStop = random.chance(0.1) ? random.below(4) : -1;
	const Progress progress = [&](double fractionDone, const std::string& message) {
		findings.expect(fractionDone >= 0 && fractionDone <= 1 && !message.empty(),
						"progress of " + std::to_string(fractionDone));
		return callsUntilStop < 0 || callsUntilStop-- > 0;
	};
	Positions positions = assembly.originalPositions;
	BoundedStrainReport report;
	try {
		report = boundedStrain(assembly, positions, options, progress);
	} catch (...) {
		findings.expect(positions == assembly.originalPositions, "positions changed by a run that threw");
		throw;
	}
	if (report.status == Status::Stopped || report.status == Status::NothingToDo)
		findings.expect(positions == assembly.originalPositions,
						"positions changed though " + describe(report.status));
	findings.expect(positions.allFinite(), "positions that are not finite");
	for (int place = 0; place < assembly.placeCount(); ++place)
		findings.expect(!assembly.placeFixed[place] ||
							positions.col(place) == assembly.originalPositions.col(place),
						"a held vertex has moved");
	findings.expect(!converged(report.status) || report.beyondBounds <= 1.001e-4,
					"converged though beyond the bounds");
	FlattenOptions flat;
	flat.bounds = options.bounds;
	flat.grain = options.grain;
	checkBounds(assembly, positions, flattenPatches(assembly, positions, flat), findings);
}

} // namespace developable::fuzz
