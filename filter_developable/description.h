// SPDX-License-Identifier: GPL-3.0-or-later
// description.h: what other programs are told of the filters; python/generate_filters.py asks for it.
#pragma once

#include <QtGlobal>

/// All filters with their parameters, all statuses and all reasons, as JSON in UTF-8:
///
///   {"filters": [{"name" in menus, "python_name", "short_name", "class", "help" in simple HTML,
///                 "parameters": [{"name", "type": "bool", "int", "float", "length", "enumeration" or "mesh",
///                                 "default", "label", "tooltip", "unit", "minimum" and "maximum": null for
///                                 none, "minimum_excluded", "automatic": -1 leaves the choice to the filter,
///                                 "choices", "only_for_solver": the one that looks at it, or "",
///                                 "positive_for_solver": the one that excludes the minimum, or ""}]}],
///    "statuses": [{"number", "name", "text"}], "reasons": [{"number", "name", "text"}], "strain_left": text,
///    "warnings": [{"key", "limit", "text"}]}
///
/// A reason's text takes the place of the status's where it is not empty; {names} in it stand for results.
/// What `strain_left` says follows where {edge_strain_left} is above 0, the reason's text lacks it, and there
/// is curvature left that it comes of. \return  ends with 0; lives as long as the plugin is loaded
extern "C" Q_DECL_EXPORT const char* developable_description();
