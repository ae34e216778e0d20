// SPDX-License-Identifier: GPL-3.0-or-later
// cut_layer.h: panels written to a layer: labels, colours, and vertices doubled along seams.
#pragma once

#include "layer.h"

#include "developable/panels/cut_into_panels.h"

namespace developable::plugin {

/// Doubles vertices along seams and darts and splits faces, with all attributes: of a vertex on an edge they
/// are those between the edge's ends, of a part of a face those of the face. Vertices and faces that are
/// there keep their numbers; new ones follow.
/// \param singlePrecision  see TriangleMesh
void cutLayer(Layer& layer, const CutMesh& cut, bool singlePrecision);

/// The number of each face's panel as its quality, and in custom attributes of the faces: `panel` and what
/// the panel's report says, as `panel_status` (of Status), `panel_curvature_before`, `panel_curvature` and
/// others. Faces that are not worked on have the panel -1. \param faceOfTriangle  per triangle of the cut,
/// its face of the layer
void labelPanels(Layer& layer, const CutResult& result, const std::vector<int>& faceOfTriangle);

/// A colour per panel, such that neighbours differ.
void colourPanels(Layer& layer, const CutResult& result, const std::vector<int>& faceOfTriangle);

} // namespace developable::plugin
