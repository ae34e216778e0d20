// SPDX-License-Identifier: GPL-3.0-or-later
// face_data.h: writes values of patches to custom attributes of the faces that they were read from.
//
// What an attribute of the same name had before is gone.
#pragma once

#include "host.h"

#include "developable/mesh/mesh.h"

#include <string>

namespace developable::plugin {

/// \param values     per patch
/// \param elsewhere  for faces that were not worked on
void writeFaceScalars(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
					  const Eigen::VectorXd& values, double elsewhere = 0);
/// \param points  3 x patches; the origin for faces that were not worked on
void writeFacePoints(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
					 const Positions& points);

} // namespace developable::plugin
