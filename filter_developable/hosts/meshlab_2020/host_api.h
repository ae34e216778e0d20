// SPDX-License-Identifier: GPL-3.0-or-later
// host_api.h: what MeshLab 2020.09 calls the things that every host has.
#pragma once

#include <QObject>
#include <common/interfaces.h>

namespace developable::plugin::host {

using Interface = MeshFilterInterface;
using ReadDocument = MeshDocument; ///< as the host hands it over when it asks for parameters
using Scalar = MESHLAB_SCALAR;
using LengthParameter = RichAbsPerc;

inline void updateBoxAndNormals(MeshModel& model) {
	model.UpdateBoxAndNormals();
}

/// A parameter that stands for a layer, at first the current one.
inline RichMesh layerParameter(const QString& name, MeshDocument& document, const QString& label,
							   const QString& tooltip) {
	// Without a layer the host insists that there is no document either.
	return RichMesh(name, document.mm(), document.mm() != nullptr ? &document : nullptr, label, tooltip);
}

/// Null when the document has no such layer.
inline const MeshModel* chosenLayer(const RichParameterList& parameters, const QString& name,
									const MeshDocument&) {
	return parameters.getMesh(name);
}

} // namespace developable::plugin::host
