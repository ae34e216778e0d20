// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_maker.h: from the patches of an assembly to patterns, laid out and measured.
#pragma once

#include "../exceptions.h"
#include "../pattern_measures.h"
#include "panel_flattener.h"
#include "pattern_layout.h"

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
		outerLoops.reserve(assembly_.patchCount());
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			outerLoops.push_back(outerLoop(piece));
		standUpright(assembly_, positions_, patterns_, outerLoops, firstVertex_);
		laySideBySide(patterns_, firstVertex_, gap);
		describePieces();
		measurePatterns(assembly_, positions_, patterns_);
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
		orderVertices();
		patterns_.positions.resize(2, firstVertex_.back());
		patterns_.placeOfVertex.resize(firstVertex_.back());
		patterns_.pieceOfVertex.resize(firstVertex_.back());
		for (int corner = 0; corner < 3 * assembly_.triangleCount(); ++corner) {
			const int piece = assembly_.patchOfTriangle[corner / 3];
			const PanelMesh& mesh = flat_[piece].mesh;
			const int vertex = patternVertex(piece, mesh.start(panelCorner(corner)));
			patterns_.triangles.data()[corner] = vertex;
			patterns_.placeOfVertex[vertex] = assembly_.trianglePlaces.data()[corner];
			patterns_.pieceOfVertex[vertex] = piece;
			if (mesh.joinedHalfEdge[panelHalfEdge(corner)] < 0)
				patterns_.joinedHalfEdge[corner] = -1;
		}
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			for (int vertex = 0; vertex < flat_[piece].mesh.vertexCount(); ++vertex)
				patterns_.positions.col(patternVertex(piece, vertex)) = flat_[piece].positions.col(vertex);
	}

	/// Within a piece vertices follow the order of their places, so that a disk keeps the model's order.
	void orderVertices() {
		std::vector<int> place(firstVertex_.back()), order(firstVertex_.back());
		for (int corner = 0; corner < 3 * assembly_.triangleCount(); ++corner) {
			const int piece = assembly_.patchOfTriangle[corner / 3];
			place[firstVertex_[piece] + flat_[piece].mesh.start(panelCorner(corner))] =
				assembly_.trianglePlaces.data()[corner];
		}
		std::iota(order.begin(), order.end(), 0);
		for (int piece = 0; piece < assembly_.patchCount(); ++piece)
			std::stable_sort(order.begin() + firstVertex_[piece], order.begin() + firstVertex_[piece + 1],
							 [&](int a, int b) { return place[a] < place[b]; });
		patternVertex_.resize(order.size());
		for (std::size_t i = 0; i < order.size(); ++i)
			patternVertex_[order[i]] = static_cast<int>(i);
	}

	int patternVertex(int piece, int panelVertex) const {
		return patternVertex_[firstVertex_[piece] + panelVertex];
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
				vertices.push_back(patternVertex(piece, flat_[piece].mesh.start(h)));
			}
			if (area > largest) {
				largest = area;
				outer = std::move(vertices);
			}
		}
		return outer;
	}

	/// What only the making of a piece can tell.
	void describePieces() {
		patterns_.pieces.resize(assembly_.patchCount());
		for (int piece = 0; piece < assembly_.patchCount(); ++piece) {
			FlatPiece& flat = patterns_.pieces[piece];
			flat.holes = static_cast<int>(loops_[piece].size()) - 1;
			flat.cuts = flat_[piece].cuts;
			flat.converged = flat_[piece].minimum.converged;
			flat.iterations = flat_[piece].minimum.iterations;
		}
	}

	const PatchAssembly& assembly_;
	const Positions& positions_;
	std::vector<char> turned_;       // per triangle of the assembly
	std::vector<int> panelTriangle_; // per triangle of the assembly
	std::vector<PanelMesh> panels_;
	std::vector<std::vector<std::vector<int>>> loops_; // per panel
	std::vector<FlatPanel> flat_;
	std::vector<int> firstVertex_;   // pieces + 1, where each one's vertices begin
	std::vector<int> patternVertex_; // of every panel's vertices in turn
	FlatPatterns patterns_;
};

} // namespace developable::detail
