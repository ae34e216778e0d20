// SPDX-License-Identifier: GPL-3.0-or-later
// run_filter.cpp: checks of the parameters, the log, and what exceptions say.
#include "run_filter.h"

#include "developable/mesh/mesh.h"

#include <cmath>
#include <new>
#include <utility>

namespace developable::plugin {

namespace {

[[noreturn]] void refuse(const Parameter& parameter, const std::string& value, const std::string& advice) {
	throw InvalidParameter("The parameter '" + parameter.name + "' is " + value + ": " + advice);
}

/// \param minimumExcluded  also when the parameter's own range has it
void checkNumber(const Parameter& parameter, double value, bool minimumExcluded) {
	const Range& range = parameter.range;
	if (!std::isfinite(value))
		refuse(parameter, formatted(value), "choose a finite number.");
	if (value >= range.minimum && value <= range.maximum && !(minimumExcluded && value == range.minimum))
		return;
	std::string advice = minimumExcluded ? "choose more than " + formatted(range.minimum)
										 : "choose " + formatted(range.minimum) + " or more";
	if (std::isfinite(range.maximum))
		advice += ", and at most " + formatted(range.maximum);
	if (minimumExcluded && !range.minimumExcluded)
		advice += " with the solver " + parameter.positiveForSolver;
	refuse(parameter, formatted(value), advice + ".");
}

void checkEnumeration(const Parameter& parameter, int index) {
	if (index >= 0 && index < static_cast<int>(parameter.values.size()))
		return;
	std::string choices;
	for (std::size_t i = 0; i < parameter.values.size(); ++i)
		choices += (i > 0 ? ", " : "") + std::to_string(i) + " (" + parameter.values[i] + ")";
	refuse(parameter, std::to_string(index), "choose one of " + choices + ".");
}

/// The choice of the filter's parameter `solver`; empty when it has none.
std::string chosenSolver(const FilterDescription& filter, const ParameterValues& values) {
	for (const Parameter& parameter : filter.parameters)
		if (parameter.name == "solver") {
			checkEnumeration(parameter, values.integer("solver"));
			return parameter.values[std::size_t(values.integer("solver"))];
		}
	return "";
}

void check(const Parameter& parameter, const ParameterValues& values, const std::string& solver) {
	const bool minimumExcluded =
		parameter.range.minimumExcluded || (!solver.empty() && parameter.positiveForSolver == solver);
	switch (parameter.type) {
	case ParameterType::Int:
		checkNumber(parameter, values.integer(parameter.name), minimumExcluded);
		break;
	case ParameterType::Float:
	case ParameterType::Length:
		checkNumber(parameter, values.number(parameter.name), minimumExcluded);
		break;
	case ParameterType::Enumeration:
		checkEnumeration(parameter, values.integer(parameter.name));
		break;
	case ParameterType::Bool:
	case ParameterType::Mesh:
		break;
	}
}

} // namespace

Results runFilter(const FilterDescription& filter, FilterCall& call) {
	const std::string solver = chosenSolver(filter, call.values);
	for (const Parameter& parameter : filter.parameters)
		check(parameter, call.values, solver);
	std::vector<std::string> lines;
	std::string verdict;
	const auto log = std::exchange(call.log, [&](const std::string& line) { lines.push_back(line); });
	call.verdict = [&](const std::string& words) { verdict = words; };
	Results results = filter.run(call);
	call.log = log;
	log(verdict.empty() ? filter.name : filter.name + ": " + verdict);
	for (const Result& result : results)
		lines.push_back(logLine(result));
	for (const std::string& line : lines)
		log(line);
	return results;
}

std::string sentenceForCurrentException() {
	try {
		throw;
	} catch (const std::bad_alloc&) {
		return "There is not enough memory for this mesh: close other layers or simplify it. Nothing was "
			   "changed.";
	} catch (const std::exception& exception) {
		return exception.what();
	} catch (...) {
		return "The filter ended with an unknown error. Nothing was changed.";
	}
}

} // namespace developable::plugin
