// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_maker.h: from the patches of an assembly to patterns, laid out, measured and described.
#pragma once

#include "../exceptions.h"
#include "boundary_crossings.h"
#include "panel_flattener.h"
#include "pattern_layout.h"

#include <numeric>

namespace developable::detail {

/// Puts panels together into patterns.
class PatternMaker {
public:
	PatternMaker(const PatchAssembly& assembly, const Positions& positions)
		: assembly_(assembly), positions_(positions), turned_(triangleTurned(assembly, positions)),
		  panelTriangle_(assembly.triangleCount()) {
		patterns_.triangles.resize(3, assembly.triangleCount());
		patterns_.joinedHalfEdge = assembly.joinedHalfEdge;
		for (const std::vector<int>& triangles : trianglesOfPatches(assembly)) {
			panels_.push_back(makePanel(assembly, positions, triangles, turned_, panelTriangle_));
			loops_.push_back(boundaryLoops(panels_.back()));
		}
		requireNoHandles();
	}

	/// \param iterations  at most, for each panel
	/// \return  false when the user asked for a stop
	bool flattenPanels(int iterations, const Progress& progress) {
		double done = 0;
		for (int piece = 0; piece < assembly_.patchCount(); ++piece) {
			const double share = double(assembly_.patches[piece].triangles) / assembly_.triangleCount();
			const Progress panelProgress = [&](double fraction, const std::string& message) {
				return mayGoOn(progress, done + share * fraction, message);
			};
			flat_.push_back(PanelFlattener(panels_[piece], iterations, panelProgress).flatten());
			if (flat_.back().minimum.stopped)
				return false;
			done += share;
		}
		return true;
	}

	FlatPatterns makePatterns(double gap) {
		joinPanels();
		std::vector<std::vector<int>> outerLoops;
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			outerLoops.push_back(outerLoop(piece));
		standUpright(assembly_, positions_, patterns_, outerLoops, firstVertex_);
		laySideBySide(patterns_, firstVertex_, gap);
		patterns_.seams = findSeams(assembly_, patterns_);
		measureEdges();
		findOverlaps();
		summarize();
		return std::move(patterns_);
	}

private:
	void requireNoHandles() const {
		int withHandles = 0;
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			withHandles +=
				assembly_.patches[piece].eulerCharacteristic() + static_cast<int>(loops_[piece].size()) != 2;
		if (withHandles > 0)
			throw PatchWithHandles(
				counted(withHandles, "patch has a handle", "patches have handles") +
				", like the handle of a cup, and can't be laid flat: cut it open, or give it seams "
				"(see the parameter 'patches').");
	}

	/// How a corner of the assembly, or a half edge, is called in its panel.
	int panelCorner(int corner) const {
		const int t = corner / 3;
		return 3 * panelTriangle_[t] + (turned_[t] ? 3 - corner % 3 : corner % 3) % 3;
	}
	int panelHalfEdge(int h) const {
		return 3 * panelTriangle_[h / 3] + (turned_[h / 3] ? reversedHalfEdge(h) : h) % 3;
	}

	void joinPanels() {
		firstVertex_ = {0};
		for (const FlatPanel& flat : flat_)
			firstVertex_.push_back(firstVertex_.back() + flat.mesh.vertexCount());
		patterns_.positions.resize(2, firstVertex_.back());
		patterns_.placeOfVertex.resize(firstVertex_.back());
		patterns_.pieceOfVertex.resize(firstVertex_.back());
		for (int corner = 0; corner < 3 * assembly_.triangleCount(); ++corner) {
			const int piece = assembly_.patchOfTriangle[corner / 3];
			const PanelMesh& mesh = flat_[piece].mesh;
			const int vertex = firstVertex_[piece] + mesh.start(panelCorner(corner));
			patterns_.triangles.data()[corner] = vertex;
			patterns_.placeOfVertex[vertex] = assembly_.trianglePlaces.data()[corner];
			patterns_.pieceOfVertex[vertex] = piece;
			if (mesh.joinedHalfEdge[panelHalfEdge(corner)] < 0)
				patterns_.joinedHalfEdge[corner] = -1;
		}
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			patterns_.positions.middleCols(firstVertex_[piece], flat_[piece].mesh.vertexCount()) =
				flat_[piece].positions;
	}

	/// The boundary that encloses the largest area, as vertices of the patterns.
	std::vector<int> outerLoop(int piece) const {
		std::vector<int> outer;
		double largest = -std::numeric_limits<double>::infinity();
		for (const std::vector<int>& loop : boundaryLoops(flat_[piece].mesh)) {
			double area = 0;
			std::vector<int> vertices;
			for (const int h : loop) {
				const auto a = flat_[piece].positions.col(flat_[piece].mesh.start(h));
				const auto b = flat_[piece].positions.col(flat_[piece].mesh.end(h));
				area += a[0] * b[1] - a[1] * b[0];
				vertices.push_back(firstVertex_[piece] + flat_[piece].mesh.start(h));
			}
			if (area > largest) {
				largest = area;
				outer = std::move(vertices);
			}
		}
		return outer;
	}

	/// Strains and energies from the coordinates as they are laid.
	void measureEdges() {
		patterns_.edgeStrain = patterns_.elasticEnergy = Eigen::VectorXd::Zero(patterns_.vertexCount());
		patterns_.pieces.resize(assembly_.patchCount());
		std::vector<int> edges(assembly_.patchCount(), 0);
		for (int h = 0; h < 3 * assembly_.triangleCount(); ++h) {
			if (patterns_.joinedHalfEdge[h] >= 0 && patterns_.joinedHalfEdge[h] < h)
				continue;
			const int ends[] = {patterns_.vertexAt(h), patterns_.vertexAt(nextCorner(h))};
			const double length = (positions_.col(patterns_.placeOfVertex[ends[1]]) -
								   positions_.col(patterns_.placeOfVertex[ends[0]]))
									  .norm();
			const double change = patterns_.length(h) - length, strain = std::abs(change) / length;
			const int pieceNumber = assembly_.patchOfTriangle[h / 3];
			FlatPiece& piece = patterns_.pieces[pieceNumber];
			piece.maxEdgeStrain = std::max(piece.maxEdgeStrain, strain);
			piece.meanEdgeStrain += strain;
			piece.elasticEnergy += change * change;
			++edges[pieceNumber];
			for (const int vertex : ends) {
				patterns_.edgeStrain[vertex] = std::max(patterns_.edgeStrain[vertex], strain);
				patterns_.elasticEnergy[vertex] += change * change / 2;
			}
		}
		FlattenReport& report = patterns_.report;
		for (int piece = 0; piece < assembly_.patchCount(); ++piece) {
			FlatPiece& flat = patterns_.pieces[piece];
			report.meanEdgeStrain += flat.meanEdgeStrain;
			flat.meanEdgeStrain /= edges[piece];
		}
		report.meanEdgeStrain /= std::accumulate(edges.begin(), edges.end(), 0);
	}

	void findOverlaps() {
		std::vector<BoundarySegment> segments;
		for (int h = 0; h < 3 * assembly_.triangleCount(); ++h)
			if (patterns_.joinedHalfEdge[h] < 0)
				segments.push_back({patterns_.vertexAt(h), patterns_.vertexAt(nextCorner(h)),
									assembly_.patchOfTriangle[h / 3]});
		const std::vector<char> crossing =
			crossingPieces(patterns_.positions, std::move(segments), assembly_.patchCount());
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			patterns_.pieces[piece].overlapping = crossing[piece] != 0;
	}

	void summarize() {
		FlattenReport& report = patterns_.report;
		report.pieces = assembly_.patchCount();
		for (int piece = 0; piece < assembly_.patchCount(); ++piece) {
			FlatPiece& flat = patterns_.pieces[piece];
			flat.holes = static_cast<int>(loops_[piece].size()) - 1;
			flat.cuts = flat_[piece].cuts;
			flat.flippedFaces = countFlipped(flat_[piece].mesh.triangles, flat_[piece].positions);
			flat.converged = flat_[piece].minimum.converged;
			flat.iterations = flat_[piece].minimum.iterations;
			report.maxEdgeStrain = std::max(report.maxEdgeStrain, flat.maxEdgeStrain);
			report.elasticEnergy += flat.elasticEnergy;
			report.flippedFaces += flat.flippedFaces;
			report.overlappingPieces += flat.overlapping;
			addNotes(piece, flat);
		}
		for (const Seam& seam : patterns_.seams)
			report.maxSeamMismatch = std::max(report.maxSeamMismatch, seam.mismatch());
	}

	void addNotes(int piece, const FlatPiece& flat) {
		const auto note = [&](const std::string& text) {
			patterns_.report.notes.push_back("Piece " + std::to_string(piece + 1) + " " + text);
		};
		if (flat.cuts > 0)
			note("has " + counted(flat.holes + 1, "boundary", "boundaries") + " and was cut open along " +
				 counted(flat.cuts, "path", "paths") + ", without which it can't be flat.");
		if (flat.overlapping)
			note("overlaps itself or another: cut it in two, or give it seams.");
		if (flat.flippedFaces > 0)
			note("has " + counted(flat.flippedFaces, "flipped face", "flipped faces") + ": give it seams.");
		else if (!flat.converged)
			note("was still getting better after " + counted(flat.iterations, "step", "steps") +
				 ": it is far from developable.");
	}

	const PatchAssembly& assembly_;
	const Positions& positions_;
	std::vector<char> turned_;       // per triangle of the assembly
	std::vector<int> panelTriangle_; // per triangle of the assembly
	std::vector<PanelMesh> panels_;
	std::vector<std::vector<std::vector<int>>> loops_; // per panel
	std::vector<FlatPanel> flat_;
	std::vector<int> firstVertex_; // pieces + 1
	FlatPatterns patterns_;
};

} // namespace developable::detail
