// SPDX-License-Identifier: GPL-3.0-or-later
// layer.h: a mesh of the host's document, as filters see it.
#pragma once

#include "host.h"

namespace developable::plugin {

class Layer {
public:
	explicit Layer(MeshModel& model) : model_(model) {}

	CMeshO& mesh() { return model_.cm; }
	const CMeshO& mesh() const { return model_.cm; }

	/// Of the bounding box.
	double diagonal() const { return double(model_.cm.bbox.Diag()); }

	/// To be called once after positions were written.
	void positionsChanged() { host::updateBoxAndNormals(model_); }

	/// To be called once after faces were given other vertices.
	void facesChanged() {
		model_.clearDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
		positionsChanged();
	}

	void enableVertexQuality() { model_.updateDataMask(MeshModel::MM_VERTQUALITY); }
	void enableVertexColours() { model_.updateDataMask(MeshModel::MM_VERTCOLOR); }
	void enableFaceQuality() { model_.updateDataMask(MeshModel::MM_FACEQUALITY); }
	void enableFaceColours() { model_.updateDataMask(MeshModel::MM_FACECOLOR); }
	bool hasTextureCoordinates() const { return model_.hasDataMask(MeshModel::MM_WEDGTEXCOORD); }
	bool hasVertexTextureCoordinates() const { return model_.hasDataMask(MeshModel::MM_VERTTEXCOORD); }
	void enableTextureCoordinates() { model_.updateDataMask(MeshModel::MM_WEDGTEXCOORD); }

private:
	MeshModel& model_;
};

} // namespace developable::plugin
