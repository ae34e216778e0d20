// SPDX-License-Identifier: GPL-3.0-or-later
// practical_notes.h: what a verdict means in practice: the strain that is left, and whether a shape is still
// itself.
#pragma once

#include "panel_output.h"

#include <optional>

namespace developable::plugin {

/// The greatest edge strain of the patches that are not developable but have little curvature left, laid flat
/// as they are; nothing where there are none, where another has much left, or where one can't be laid flat.
/// \return  per cent
std::optional<double> strainLeft(const PatchAssembly& assembly, const Positions& positions,
								 const std::vector<PanelReport>& panels);

} // namespace developable::plugin
