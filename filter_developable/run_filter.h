// SPDX-License-Identifier: GPL-3.0-or-later
// run_filter.h: runs a filter the same way in every host.
#pragma once

#include "filter_description.h"

namespace developable::plugin {

/// Checks the parameters, runs the filter and logs what it returns.
/// \throws InvalidParameter  when a parameter is out of its range
/// \throws whatever the filter throws; the mesh is then as it was
Results runFilter(const FilterDescription& filter, FilterCall& call);

/// The sentence to show for an exception that ended a filter. To be called where it was caught.
std::string sentenceForCurrentException();

} // namespace developable::plugin
