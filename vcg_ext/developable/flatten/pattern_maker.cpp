// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_maker.cpp: panels flattened one by one, and their vertices numbered anew in the patterns.
#include "pattern_maker.h"

#include "bounded_layout.h"
#include "pattern_layout.h"
#include "pattern_measures.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace developable::detail {

PatternMaker::PatternMaker(const PatchAssembly& assembly, const Positions& positions)
	: assembly_(assembly), positions_(positions), maker_(assembly, positions) {
	patterns_.triangles.resize(3, assembly.triangleCount());
	patterns_.joinedHalfEdge = assembly.joinedHalfEdge;
	for (int piece = 0; piece < assembly.patchCount(); ++piece) {
		panels_.push_back(maker_.panel(piece));
		loops_.push_back(boundaryLoops(panels_.back()));
	}
	requireNoHandles();
}

void PatternMaker::requireNoHandles() const {
	const std::vector<int> withHandles = indicesWhere(assembly_.patchCount(), [&](int piece) {
		return assembly_.patches[piece].eulerCharacteristic() + static_cast<int>(loops_[piece].size()) != 2;
	});
	if (!withHandles.empty())
		throw PatchWithHandles(
			counted(withHandles.size(), "patch has a handle", "patches have handles") +
			", like the handle of a cup, and can't be laid flat: cut it open ('developable cut' on the command "
			"line, the filter Cut into Developable Panels in MeshLab), or give it seams (see the parameter "
			"'patches')." +
			seePatch(assembly_, withHandles.front()));
}

bool PatternMaker::flattenPanels(int iterations, bool leastSquares, int threads, const Progress& progress) {
	flat_.resize(assembly_.patchCount());
	forEachPiece(threads, progress, [&](int piece, const Progress& ofPiece) {
		flat_[piece] = flattenPanel(panels_[piece], iterations, leastSquares, ofPiece);
	});
	return std::none_of(flat_.begin(), flat_.end(),
						[](const FlatPanel& flat) { return flat.minimum.stopped; });
}

void PatternMaker::keepWithin(const StrainBounds& bounds, const Grain& grain, bool onlyWithin, int threads) {
	patterns_.bounds = bounds;
	patterns_.grain = grain;
	if (!bounds.any())
		return;
	joinPanels();
	const auto sides = longestSides(assembly_, patterns_, outerLoops());
	forEachPiece(threads, {}, [&](int piece, const Progress&) {
		flat_[piece].positions = boundedLayout(flat_[piece].mesh, flat_[piece].positions, bounds, grain,
											   panelVertices(piece, sides[piece]), onlyWithin);
	});
}

void PatternMaker::forEachPiece(int threads, const Progress& progress,
								const std::function<void(int, const Progress&)>& work) const {
	std::vector<Task> tasks;
	tasks.reserve(assembly_.patchCount());
	for (int piece = 0; piece < assembly_.patchCount(); ++piece)
		tasks.push_back({double(assembly_.patches[piece].triangles),
						 [&work, piece](const Progress& ofPiece) { work(piece, ofPiece); }});
	runTasks(tasks, threads, progress);
}

std::array<int, 2> PatternMaker::panelVertices(int piece, const std::array<int, 2>& patternVertices) const {
	std::array<int, 2> result = {-1, -1};
	for (int vertex = 0; vertex < flat_[piece].mesh.vertexCount(); ++vertex)
		for (const int end : {0, 1})
			if (patternVertex(piece, vertex) == patternVertices[end])
				result[end] = vertex;
	return result;
}

std::vector<std::vector<int>> PatternMaker::outerLoops() const {
	std::vector<std::vector<int>> loops;
	loops.reserve(assembly_.patchCount());
	for (int piece = 0; piece < assembly_.patchCount(); ++piece)
		loops.push_back(outerLoop(piece));
	return loops;
}

FlatPatterns PatternMaker::makePatterns(double gap) {
	joinPanels();
	const auto sides = longestSides(assembly_, patterns_, outerLoops());
	standUpright(positions_, patterns_, sides, firstVertex_);
	laySideBySide(patterns_, firstVertex_, gap);
	describePieces();
	for (int piece = 0; piece < assembly_.patchCount(); ++piece)
		patterns_.pieces[piece].longestSide = sides[piece];
	measurePatterns(assembly_, positions_, patterns_);
	return std::move(patterns_);
}

void PatternMaker::joinPanels() {
	firstVertex_ = {0};
	for (const FlatPanel& flat : flat_)
		firstVertex_.push_back(firstVertex_.back() + flat.mesh.vertexCount());
	orderVertices();
	patterns_.positions.resize(2, firstVertex_.back());
	patterns_.placeOfVertex.resize(firstVertex_.back());
	patterns_.pieceOfVertex.resize(firstVertex_.back());
	for (int corner = 0; corner < static_cast<int>(patterns_.triangles.size()); ++corner) {
		const int piece = assembly_.patchOfTriangle[triangleOf(corner)];
		const PanelMesh& mesh = flat_[piece].mesh;
		const int vertex = patternVertex(piece, mesh.start(maker_.panelCorner(corner)));
		patterns_.triangles.data()[corner] = vertex;
		patterns_.placeOfVertex[vertex] = assembly_.placeAt(corner);
		patterns_.pieceOfVertex[vertex] = piece;
		if (mesh.joinedHalfEdge[maker_.panelHalfEdge(corner)] < 0)
			patterns_.joinedHalfEdge[corner] = -1;
	}
	for (int piece = 0; piece < assembly_.patchCount(); ++piece)
		for (int vertex = 0; vertex < flat_[piece].mesh.vertexCount(); ++vertex)
			patterns_.positions.col(patternVertex(piece, vertex)) = flat_[piece].positions.col(vertex);
}

void PatternMaker::orderVertices() {
	std::vector<int> place(firstVertex_.back()), order(firstVertex_.back());
	for (int corner = 0; corner < static_cast<int>(patterns_.triangles.size()); ++corner) {
		const int piece = assembly_.patchOfTriangle[triangleOf(corner)];
		place[firstVertex_[piece] + flat_[piece].mesh.start(maker_.panelCorner(corner))] =
			assembly_.placeAt(corner);
	}
	std::iota(order.begin(), order.end(), 0);
	for (int piece = 0; piece < assembly_.patchCount(); ++piece)
		std::stable_sort(order.begin() + firstVertex_[piece], order.begin() + firstVertex_[piece + 1],
						 [&](int a, int b) { return place[a] < place[b]; });
	patternVertex_.resize(order.size());
	for (std::size_t i = 0; i < order.size(); ++i)
		patternVertex_[order[i]] = static_cast<int>(i);
}

std::vector<int> PatternMaker::outerLoop(int piece) const {
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

void PatternMaker::describePieces() {
	patterns_.pieces.resize(assembly_.patchCount());
	for (int piece = 0; piece < assembly_.patchCount(); ++piece) {
		FlatPiece& flat = patterns_.pieces[piece];
		flat.holes = static_cast<int>(loops_[piece].size()) - 1;
		flat.cuts = flat_[piece].cuts;
		flat.converged = flat_[piece].minimum.converged;
		flat.iterations = flat_[piece].minimum.iterations;
	}
}

} // namespace developable::detail
