// SPDX-License-Identifier: GPL-3.0-or-later
// triangulate_polygons.cpp: the filter Triangulate Polygons (Constrained Delaunay) (Section 3.1).
#include "../layer.h"
#include "filters.h"

#include "developable/polygons/polygon_triangulation.h"

namespace developable::plugin {

namespace {

Results runTriangulate(FilterCall& call) {
	const PolygonReport report = triangulatePolygons(call.layer.mesh());
	if (report.edgesChanged > 0)
		call.layer.facesChanged();
	call.verdict(std::to_string(report.polygons) + " polygons, " + std::to_string(report.edgesChanged) +
				 " diagonals changed");
	return {
		{"polygons", report.polygons, ""},
		{"edges_changed", report.edgesChanged, ""},
		{"skipped", report.skipped, ""},
	};
}

} // namespace

FilterDescription polygonTriangulation() {
	FilterDescription filter;
	filter.name = "Triangulate Polygons (Constrained Delaunay)";
	filter.pythonName = "meshing_polygons_to_constrained_delaunay";
	filter.shortName = "triangulate";
	filter.filterClass = FilterClass::Remeshing;
	filter.change = Change::Faces;
	filter.help =
		"Splits every polygon of a layer into the best triangles that its corners allow: quads and larger "
		"polygons, which are loaded as triangles joined by faux edges, get the <b>constrained Delaunay</b> "
		"triangulation of their contour in its least-squares plane, as surfaces do before they are made "
		"developable. No vertex is added or moved, sides and attributes stay, and a polygon stays a polygon: "
		"its diagonals are faux edges as before.<br><br>"
		"Polygons that cross or touch themselves when seen along that plane's normal are left as they were, "
		"as "
		"are those with a hole, a vertex inside or a texture seam across, and those whose new diagonal would "
		"be an edge that other faces share; the log says how many were skipped.<br><br>"
		"See: <i>C. C. L. Wang, K. Tang</i>, <b>Achieving developability of a polygonal surface by minimum "
		"deformation: a study of global and local optimization approaches</b>, The Visual Computer 20, 2004, "
		"Section 3.1. The triangulation is computed by CGAL.";
	filter.run = runTriangulate;
	return filter;
}

} // namespace developable::plugin
