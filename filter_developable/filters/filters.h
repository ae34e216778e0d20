// SPDX-License-Identifier: GPL-3.0-or-later
// filters.h: all filters of the plugin, in the order of its menu entries; each has a file of its own.
#pragma once

#include "../filter_description.h"

namespace developable::plugin {

FilterDescription globalDevelopability();
FilterDescription localDevelopability();
FilterDescription developabilityMaps();
FilterDescription patchFlattening();
FilterDescription panelCutting();
FilterDescription originalShapeRestoring();
#ifdef DEVELOPABLE_HAS_CGAL
FilterDescription polygonTriangulation();
#endif

inline std::vector<FilterDescription> allFilters() {
	return {
		globalDevelopability(), localDevelopability(), developabilityMaps(),
		patchFlattening(),      panelCutting(),        originalShapeRestoring(),
#ifdef DEVELOPABLE_HAS_CGAL
		polygonTriangulation(),
#endif
	};
}

} // namespace developable::plugin
