// SPDX-License-Identifier: GPL-3.0-or-later
// panel_plan.h: from patches to panels: clusters, joining, smooth seams, darts, and all sewn together.
#pragma once

#include "cut_into_panels.h"
#include "panel_joining.h"
#include "sewn_panels.h"

#include <memory>

namespace developable::detail {

class PanelPlan {
public:
	PanelPlan(const TriangleMesh& mesh, const PatchOptions& patches, const CutOptions& options,
			  const Progress& progress);

	CutResult run();

private:
	/// Every copy of a vertex is a vertex of its own, so that patches have nothing in common.
	void separatePatches(const TriangleMesh& mesh, const PatchOptions& patches);

	std::vector<double> maxDisplacements() const;

	/// Patches that are no panels become clusters of normals, each of which is one.
	void makeClusters();
	void tidyClusters();
	void divideUntilFlat();
	std::vector<char> keptTriangles() const;
	std::vector<int> withSelectedWhole(std::vector<int> labels) const;
	bool divideInTwo(int panel);
	void joinToSoFew();

	SewnPanels sewTogether(double share, bool brief);
	SewnExcess excessBeyond(double share);
	SewnPanels divideUntilAllHold();
	void joinUntilAllHold();
	int panelBefore(const CutSurface& before, const TriangleMesh& meshBefore, int panel) const;
	SewnPanels smoothSeams();
	void drawSmoothSeams(double edges);
	Progress progressOfRest();

	CutReport reportOf(const SewnPanels& sewn) const;
	CutMesh cutMesh() const;
	TriangleMesh asCut() const;

	const CutOptions options_;
	TriangleMesh mesh_; // vertices are copies of the mesh that was given, and points on its edges
	std::vector<VertexOrigin> origins_; // of its vertices, on that mesh
	std::vector<char> vertexTaken_;     // of that mesh: faces that are not worked on have it
	double givenSeamLength_ = 0;        // of seams between patches that share vertices
	std::unique_ptr<CutSurface> surface_;
	std::unique_ptr<PanelTests> tests_;
	std::vector<int> clusters_; // per triangle, before any were joined
	JoinHistory history_;
};

} // namespace developable::detail
