// SPDX-License-Identifier: GPL-3.0-or-later
// results.cpp: how results read in the log.
#include "results.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace developable::plugin {

namespace {

std::string inWords(bool value) {
	return value ? "true" : "false";
}

std::string inWords(int value) {
	return std::to_string(value);
}

std::string inWords(double value) {
	return formatted(value);
}

} // namespace

std::string formatted(double number, int digits) {
	std::array<char, 32> text;
	const auto end =
		std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits).ptr;
	return std::string(text.data(), end);
}

std::string filledIn(std::string text, const Results& results) {
	for (const Result& result : results) {
		const std::string place = '{' + result.key + '}';
		const auto* number = std::get_if<double>(&result.value);
		const std::string value = number != nullptr
									  ? formatted(*number, 4)
									  : std::visit([](auto any) { return inWords(any); }, result.value);
		for (auto at = text.find(place); at != std::string::npos; at = text.find(place))
			text.replace(at, place.size(), value);
	}
	return text;
}

std::string reasonInWords(Status status, Reason reason, const Results& results) {
	std::string text =
		reason == Reason::AsStatus ? describe(status) : reasonProperties[static_cast<int>(reason)].text;
	const bool hasStrain = std::any_of(results.begin(), results.end(), [](const Result& result) {
		return result.key == "edge_strain_left" && std::get<double>(result.value) > 0;
	});
	// Where the curvature is gone there is no strain but rounding.
	if (hasStrain && reason != Reason::NearlyThere && reason != Reason::BorderOverlaps)
		text += strainLeftText;
	return filledIn(text, results);
}

std::string logLine(const Result& result) {
	const std::string value = std::visit([](auto number) { return inWords(number); }, result.value);
	return result.key + ": " + (result.words.empty() ? value : result.words);
}

} // namespace developable::plugin
