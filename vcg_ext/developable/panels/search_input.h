// SPDX-License-Identifier: GPL-3.0-or-later
// search_input.h: what panels are looked for on.
#pragma once

#include "cut_into_panels.h"
#include "planned_surface.h"

namespace developable::detail {

struct SearchInput {
	const GivenPatches& patches;
	const std::vector<double>& limits; ///< per patch, how far its panels may move, length
	const CutOptions& options;
	/// Whether what holds briefly should hold as the user will have it, too; not on a copy of the patches,
	/// for it will be sewn together elsewhere.
	bool confirmed = true;
};

} // namespace developable::detail
