// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_measures.cpp: measures of every edge, triangle and boundary, and the notes that follow from them.
#include "pattern_measures.h"

#include "boundary_crossings.h"
#include "panel_maker.h"
#include "seams.h"

#include <algorithm>
#include <cmath>
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
								assembly.patchOfTriangle[triangleOf(h)]});
	const std::vector<char> crossing =
		detail::crossingPieces(patterns.positions, std::move(segments), assembly.patchCount());
	for (int piece = 0; piece < assembly.patchCount(); ++piece)
		patterns.pieces[piece].overlapping = crossing[piece] != 0;
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
	else if (!piece.converged)
		note("was still getting better after " + counted(piece.iterations, "step", "steps") +
			 ": it is far from developable.");
}

} // namespace

void measurePatterns(const PatchAssembly& assembly, const Positions& model, FlatPatterns& patterns) {
	patterns.report = {};
	FlattenReport& report = patterns.report;
	measureEdges(assembly, model, patterns);
	findFlips(assembly, model, patterns);
	findOverlaps(assembly, patterns);
	report.pieces = assembly.patchCount();
	for (int number = 0; number < assembly.patchCount(); ++number) {
		const FlatPiece& piece = patterns.pieces[number];
		report.maxEdgeStrain = std::max(report.maxEdgeStrain, piece.maxEdgeStrain);
		report.elasticEnergy += piece.elasticEnergy;
		report.flippedFaces += piece.flippedFaces;
		report.overlappingPieces += piece.overlapping;
		addNotes(number, piece, report.notes);
	}
	patterns.seams = findSeams(assembly, patterns);
	for (const Seam& seam : patterns.seams)
		report.maxSeamMismatch = std::max(report.maxSeamMismatch, seam.mismatch());
}

} // namespace developable
