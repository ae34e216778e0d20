// SPDX-License-Identifier: GPL-3.0-or-later
// pattern_maker.h: from the patches of an assembly to patterns, laid out and measured.
#pragma once

#include "flat_patterns.h"
#include "panel_flattener.h"
#include "panel_maker.h"

#include <functional>

namespace developable::detail {

/// Puts panels together into patterns.
class PatternMaker {
public:
	/// \param positions  3 x places
	///
	/// \throws PatchWithHandles  says how many have handles
	PatternMaker(const PatchAssembly& assembly, const Positions& positions);

	/// \param iterations  at most, for each panel
	/// \param leastSquares  see flattenPanel
	/// \param threads     see FlattenOptions
	/// \return            false when the user asked for a stop
	bool flattenPanels(int iterations, bool leastSquares, int threads, const Progress& progress);

	/// After the panels are flat: brings their triangles within the bounds, if there are any.
	void keepWithin(const StrainBounds& bounds, const Grain& grain, bool onlyWithin, int threads);

	/// Once, after the panels are flat.
	/// \param gap  see FlattenOptions
	FlatPatterns makePatterns(double gap);

private:
	void requireNoHandles() const;

	/// Pieces side by side; what comes of one depends on no other.
	void forEachPiece(int threads, const Progress& progress,
					  const std::function<void(int, const Progress&)>& work) const;

	void joinPanels();

	/// Within a piece vertices follow the order of their places, so that a disk keeps the model's order.
	void orderVertices();

	int patternVertex(int piece, int panelVertex) const {
		return patternVertex_[firstVertex_[piece] + panelVertex];
	}

	/// The boundary that encloses the largest area, as vertices of the patterns.
	std::vector<int> outerLoop(int piece) const;

	/// The vertices of a panel by those of the patterns; -1 stays.
	std::array<int, 2> panelVertices(int piece, const std::array<int, 2>& patternVertices) const;
	std::vector<std::vector<int>> outerLoops() const;

	/// What only the making of a piece can tell.
	void describePieces();

	const PatchAssembly& assembly_;
	const Positions& positions_;
	PanelMaker maker_;
	std::vector<PanelMesh> panels_;
	std::vector<std::vector<std::vector<int>>> loops_; // per panel
	std::vector<FlatPanel> flat_;
	std::vector<int> firstVertex_;   // pieces + 1, where each one's vertices begin
	std::vector<int> patternVertex_; // of every panel's vertices in turn
	FlatPatterns patterns_;
};

} // namespace developable::detail
