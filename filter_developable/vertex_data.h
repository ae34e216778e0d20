// SPDX-License-Identifier: GPL-3.0-or-later
// vertex_data.h: writes values of places to the vertices of the mesh that they were read from.
//
// Vertices that were not worked on keep what they had. A custom attribute that is new is 0 there, and a point
// is the vertex's own position. An attribute of the same name that holds something else is replaced.
#pragma once

#include "host.h"

#include "developable/mesh/mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace developable::plugin {

/// \param values  per place, in the mesh's own unit of length
void writeScalarAttribute(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
						  const Eigen::VectorXd& values);
/// \param points  3 x places, in the assembly's unit
void writePointAttribute(CMeshO& mesh, const std::string& name, const PatchAssembly& assembly,
						 const Positions& points);
void writeQuality(CMeshO& mesh, const PatchAssembly& assembly, const Eigen::VectorXd& values);
void writeColours(CMeshO& mesh, const PatchAssembly& assembly, const std::vector<vcg::Color4b>& colours);

/// A custom attribute of points as the places have it, in the assembly's unit, or nothing when the mesh has
/// none of that name.
std::optional<Positions> readPointAttribute(CMeshO& mesh, const std::string& name,
											const PatchAssembly& assembly);

} // namespace developable::plugin
