// SPDX-License-Identifier: GPL-3.0-or-later
// filter_description.h: a filter as every host shows it, described once.
#pragma once

#include "filter_call.h"
#include "results.h"

#include <limits>
#include <string>
#include <vector>

namespace developable::plugin {

enum class ParameterType { Bool, Int, Float, Length, Enumeration, Mesh };

/// The values that a number may have.
struct Range {
	double minimum = -std::numeric_limits<double>::infinity();
	bool minimumExcluded = false; ///< values must be greater than the minimum
	double maximum = std::numeric_limits<double>::infinity();
};

/// One parameter of a dialog and of scripts.
struct Parameter {
	std::string name; ///< in scripts
	ParameterType type = ParameterType::Bool;
	/// Of a bool 0 or 1, of an enumeration the index; of a mesh it is not used, the current layer is meant.
	double defaultValue = 0;
	std::string label; ///< in the dialog
	/// Its first sentence is all that the command line shows; more may follow.
	std::string tooltip;
	std::string unit;                     ///< of a number; empty: it has none
	Range range;                          ///< of a number
	bool automatic = false;               ///< a length whose default, -1, leaves the choice to the filter
	std::vector<std::string> values = {}; ///< of an enumeration; their order is fixed
	bool offWhenColoured = false;         ///< a bool that is false by default on a mesh with vertex colours
	std::string onlyForSolver;            ///< the choice of `solver` that looks at it; empty: any
	std::string positiveForSolver;        ///< the choice of `solver` that excludes the range's minimum
};

/// The menu that a filter is found in.
enum class FilterClass { Smoothing, Quality, Remeshing, Texture };

/// What a filter changes when it succeeds.
enum class Change { Positions, Scalars, Faces, TextureCoordinates, Panels };

struct FilterDescription {
	std::string name;       ///< in menus and in .mlx scripts
	std::string pythonName; ///< in pymeshlab
	std::string shortName;  ///< on the command line
	FilterClass filterClass = FilterClass::Smoothing;
	Change change = Change::Positions;
	std::string help; ///< simple HTML
	std::vector<Parameter> parameters;
	Results (*run)(FilterCall& call) = nullptr; ///< throws an exception when the input can't be worked on
};

} // namespace developable::plugin
