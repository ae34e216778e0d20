// SPDX-License-Identifier: GPL-3.0-or-later
// given_parts.h: what was given taken apart where nothing is shared, and what was found put together.
#pragma once

#include "cut_into_panels.h"
#include "planned_surface.h"

namespace developable::detail {

/// Patches that share no vertex with others and are not sewn to them, each as if it had been given alone:
/// what is found for one has no bearing on another. In the order of their first patches.
std::vector<GivenPatches> partsOf(const GivenPatches& given);

/// What was found for each of several parts, in their order, as one result: panels are numbered part by part,
/// notes say which part they are on.
CutResult putTogether(const std::vector<GivenPatches>& parts, const std::vector<CutResult>& results);

} // namespace developable::detail
