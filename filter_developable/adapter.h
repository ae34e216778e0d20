// SPDX-License-Identifier: GPL-3.0-or-later
// adapter.h: what the adapters of all hosts share: descriptions to host types, host values to filters.
#pragma once

#include "filter_description.h"
#include "host.h"

namespace developable::plugin {

QString toQString(const std::string& text);

/// The parameters as the host's dialogs and scripts have them, with defaults for the current layer if there
/// is one.
RichParameterList richParameters(const FilterDescription& filter, host::ReadDocument& document);

host::Interface::FilterClass menuClass(const FilterDescription& filter);

/// What of a layer a filter may change, as a mask of MeshModel::MeshElement.
int changedElements(const FilterDescription& filter);

/// Runs a filter on the document's current layer; see runFilter.
/// \throws EmptyMesh  when there is no layer
Results runOnDocument(const FilterDescription& filter, MeshDocument& document,
					  const RichParameterList& parameters, vcg::CallBackPos* callback,
					  const std::function<void(const std::string& line)>& log);

} // namespace developable::plugin
