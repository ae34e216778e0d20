// SPDX-License-Identifier: GPL-3.0-or-later
// filter_call.h: what a filter gets from the host when it runs.
#pragma once

#include "parameter_values.h"

#include "developable/mesh/mesh.h"

#include <functional>
#include <string>

namespace developable::plugin {

class Layer;

struct FilterCall {
	Layer& layer; ///< the current one
	ParameterValues values;
	Progress progress;
	std::function<void(const std::string& line)> log;
	/// Adds an empty layer, named like the current one with a suffix, and makes it the current one.
	std::function<Layer(const std::string& suffix)> addLayer;
	/// Says in a few words how it went; that stands first in the log, whatever else is logged before.
	std::function<void(const std::string& words)> verdict = [](const std::string&) {};
};

} // namespace developable::plugin
