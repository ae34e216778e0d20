// SPDX-License-Identifier: GPL-3.0-or-later
// host_api.h: what MeshLab 2022.02 and later call the things that every host has.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

namespace developable::plugin::host {

using Interface = FilterPlugin;
using ReadDocument = const MeshDocument; ///< as the host hands it over when it asks for parameters
using Scalar = Scalarm;

#if DEVELOPABLE_HOST_YEAR >= 2025
using LengthParameter = RichPercentage;
#else
using LengthParameter = RichAbsPerc;
#endif

inline void updateBoxAndNormals(MeshModel& model) {
	model.updateBoxAndNormals();
}

/// A parameter that stands for a layer, at first the current one.
inline RichMesh layerParameter(const QString& name, const MeshDocument& document, const QString& label,
							   const QString& tooltip) {
	const int id = document.mm() != nullptr ? document.mm()->id() : 0;
	return RichMesh(name, static_cast<unsigned int>(id), &document, label, tooltip);
}

/// Null when the document has no such layer.
inline const MeshModel* chosenLayer(const RichParameterList& parameters, const QString& name,
									const MeshDocument& document) {
	return document.getMesh(parameters.getMeshId(name));
}

} // namespace developable::plugin::host
