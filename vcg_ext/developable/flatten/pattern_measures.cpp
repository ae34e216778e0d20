// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_measures.cpp: measures of every edge, triangle and boundary, and the notes that follow from them.
#include "pattern_measures.h"

#include "bounded_layout.h"
#include "developable/geometry/geometry.h"
#include "grain_directions.h"
#include "panel_maker.h"
#include "seams.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

namespace developable {

namespace {

/// Strains and energies, of every edge of the patterns once.
void measureEdges(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns) {
	patterns.edgeStrain = patterns.elasticEnergy = Eigen::VectorXd::Zero(patterns.vertexCount());
	std::vector<int> edges(assembly.patchCount(), 0);
	for (FlatPiece& piece : patterns.pieces)
		piece.maxEdgeStrain = piece.meanEdgeStrain = piece.elasticEnergy = 0;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h) {
		if (patterns.joinedHalfEdge[h] > h)
			continue;
		const int ends[] = {patterns.vertexAt(h), patterns.vertexAt(nextCorner(h))};
		const double length =
			(model.col(patterns.placeOfVertex[ends[1]]) - model.col(patterns.placeOfVertex[ends[0]])).norm();
		const double change = patterns.length(h) - length, strain = std::abs(change) / length;
		const int number = assembly.patchOfTriangle[triangleOf(h)];
		FlatPiece& piece = patterns.pieces[number];
		piece.maxEdgeStrain = std::max(piece.maxEdgeStrain, strain);
		piece.meanEdgeStrain += strain;
		piece.elasticEnergy += change * change;
		++edges[number];
		for (const int vertex : ends) {
			patterns.edgeStrain[vertex] = std::max(patterns.edgeStrain[vertex], strain);
			patterns.elasticEnergy[vertex] += change * change / 2;
		}
	}
	FlattenReport& report = patterns.report;
	for (int piece = 0; piece < assembly.patchCount(); ++piece) {
		report.meanEdgeStrain += patterns.pieces[piece].meanEdgeStrain;
		patterns.pieces[piece].meanEdgeStrain /= edges[piece];
	}
	report.meanEdgeStrain /= std::accumulate(edges.begin(), edges.end(), 0);
}

/// Where a triangle of the pattern has no area at all, a strain is not a number.
double upToCollapse(double strain) {
	return strain < collapsedStretch ? strain : collapsedStretch;
}

/// Strains of all triangles, and which are beyond the bounds.
void measureTriangles(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns) {
	patterns.stretch = patterns.compression = Eigen::VectorXd::Zero(patterns.vertexCount());
	const StrainedTriangles triangles = strainedTriangles(assembly, model, patterns);
	const Eigen::Matrix2Xd strains = principalStrains(triangles, model, patterns.positions);
	const Eigen::VectorXd beyond = beyondBounds(assembly, model, patterns);
	for (FlatPiece& piece : patterns.pieces) {
		piece.maxStretch = piece.maxCompression = piece.beyondBounds = 0;
		piece.worstTriangle = -1;
		piece.collapsedFaces = 0;
	}
	for (int t = 0; t < triangles.count(); ++t) {
		FlatPiece& piece = patterns.pieces[assembly.patchOfTriangle[t]];
		const double stretch = std::max(upToCollapse(strains(0, t) - 1), 0.0),
					 compression = std::max(0.0, 1 - strains(1, t));
		const bool collapsed = stretch == collapsedStretch;
		const double excess = collapsed && patterns.bounds.any() ? collapsedStretch : upToCollapse(beyond[t]);
		piece.collapsedFaces += collapsed;
		piece.maxStretch = std::max(piece.maxStretch, stretch);
		piece.maxCompression = std::max(piece.maxCompression, compression);
		for (const int vertex : patterns.triangles.col(t)) {
			patterns.stretch[vertex] = std::max(patterns.stretch[vertex], stretch);
			patterns.compression[vertex] = std::max(patterns.compression[vertex], compression);
		}
		if (excess > piece.beyondBounds) {
			piece.beyondBounds = excess;
			piece.worstTriangle = t;
		}
	}
}

void findFlips(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns) {
	const std::vector<char> turned = detail::triangleTurned(assembly, model);
	for (FlatPiece& piece : patterns.pieces)
		piece.flippedFaces = 0;
	for (int t = 0; t < assembly.triangleCount(); ++t) {
		const double area = detail::doubleArea(patterns.positions, patterns.triangles.col(t));
		patterns.pieces[assembly.patchOfTriangle[t]].flippedFaces += !(turned[t] ? area < 0 : area > 0);
	}
}

void findOverlaps(const PatchAssembly& assembly, FlatPatterns& patterns) {
	std::vector<detail::BoundarySegment> segments;
	for (int h = 0; h < 3 * assembly.triangleCount(); ++h)
		if (patterns.joinedHalfEdge[h] < 0)
			segments.push_back({patterns.vertexAt(h), patterns.vertexAt(nextCorner(h)),
								assembly.patchOfTriangle[triangleOf(h)], h});
	std::vector<detail::PieceCrossing> crossing =
		detail::crossingPieces(patterns.positions, std::move(segments), assembly.patchCount());
	for (int piece = 0; piece < assembly.patchCount(); ++piece) {
		patterns.pieces[piece].overlapping = crossing[piece].crosses;
		patterns.pieces[piece].crossings = std::move(crossing[piece].itself);
	}
}

/// What a user should know of a piece, in sentences.
void addNotes(int number, const FlatPiece& piece, std::vector<std::string>& notes) {
	const auto note = [&](const std::string& text) {
		notes.push_back("Piece " + std::to_string(number + 1) + " " + text);
	};
	if (piece.cuts > 0)
		note("has " + counted(piece.holes + 1, "boundary", "boundaries") + " and was cut open along " +
			 counted(piece.cuts, "path", "paths") + ", without which it can't be flat.");
	if (piece.overlapping)
		note("overlaps itself or another: cut it in two, or give it seams.");
	if (piece.flippedFaces > 0)
		note("has " + counted(piece.flippedFaces, "flipped face", "flipped faces") + ": give it seams.");
	if (piece.collapsedFaces > 0)
		note("has " + counted(piece.collapsedFaces, "collapsed face", "collapsed faces") +
			 ", thinner in the pattern than a tenth: their stretch counts as 900 %. Give it seams.");
	if (piece.flippedFaces == 0 && piece.collapsedFaces == 0 && !piece.converged)
		note("was still getting better after " + counted(piece.iterations, "step", "steps") +
			 ": it is far from developable.");
}

/// Which piece is beyond the bounds, where and by how much.
void addNoteOfBounds(const PatchAssembly& assembly, const Positions& model, int number,
					 const FlatPiece& piece, std::vector<std::string>& notes) {
	const Eigen::Vector3d middle = barycentre(model, assembly.trianglePlaces.col(piece.worstTriangle));
	const Eigen::Vector3d at = inMeshUnits(assembly.lengthExponent, middle);
	char text[240];
	std::snprintf(
		text, sizeof text,
		"Piece %d has no pattern within the allowed strain: the nearest found is beyond it by %.3g %% "
		"of length, most at (%.6g, %.6g, %.6g).",
		number + 1, 100 * piece.beyondBounds, at[0], at[1], at[2]);
	notes.emplace_back(text);
}

} // namespace

void measurePatterns(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns) {
	patterns.report = {};
	FlattenReport& report = patterns.report;
	measureEdges(assembly, model, patterns);
	measureTriangles(assembly, model, patterns);
	findFlips(assembly, model, patterns);
	findOverlaps(assembly, patterns);
	report.pieces = assembly.patchCount();
	for (int number = 0; number < assembly.patchCount(); ++number) {
		const FlatPiece& piece = patterns.pieces[number];
		report.maxEdgeStrain = std::max(report.maxEdgeStrain, piece.maxEdgeStrain);
		report.elasticEnergy += piece.elasticEnergy;
		report.maxStretch = std::max(report.maxStretch, piece.maxStretch);
		report.maxCompression = std::max(report.maxCompression, piece.maxCompression);
		report.beyondBounds = std::max(report.beyondBounds, piece.beyondBounds);
		report.flippedFaces += piece.flippedFaces;
		report.collapsedFaces += piece.collapsedFaces;
		report.overlappingPieces += piece.overlapping;
		addNotes(number, piece, report.notes);
		if (piece.beyondBounds > patternTolerance)
			addNoteOfBounds(assembly, model, number, piece, report.notes);
	}
	patterns.seams = findSeams(assembly, patterns);
	for (const Seam& seam : patterns.seams)
		report.maxSeamMismatch = std::max(report.maxSeamMismatch, seam.mismatch());
}

} // namespace developable
