// SPDX-License-Identifier: GPL-3.0-or-later
// results.h: the numbers that a filter returns, in order, and how they read in the log.
#pragma once

#include "developable/mesh/mesh.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace developable::plugin {

/// Hosts hand these three types on to scripts; others they drop.
using ResultValue = std::variant<bool, int, double>;

struct Result {
	std::string key;
	ResultValue value;
	std::string words; ///< what the log says in place of the value, where that is clearer
};

using Results = std::vector<Result>;

/// A number as short as so many digits allow, with a point whatever the user's locale.
std::string formatted(double number, int digits = 9);

/// A text with each {key} in place of which that result is put; numbers with four digits.
std::string filledIn(std::string text, const Results& results);

/// Why a run ended, in a sentence. \param results  with all the numbers that it takes
std::string reasonInWords(Status status, Reason reason, const Results& results);

/// "key: value".
std::string logLine(const Result& result);

} // namespace developable::plugin
