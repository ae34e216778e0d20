// SPDX-License-Identifier: GPL-3.0-or-later
// run_filter.cpp: checks of the parameters, the log, and what exceptions say.
#include "run_filter.h"

#include "developable/mesh/mesh.h"

#include <cmath>
#include <new>

namespace developable::plugin {

namespace {

[[noreturn]] void refuse(const Parameter& parameter, const std::string& value, const std::string& advice) {
	throw InvalidParameter("The parameter '" + parameter.name + "' is " + value + ": " + advice);
}

void checkNumber(const Parameter& parameter, double value) {
	if (!std::isfinite(value))
		refuse(parameter, formatted(value), "choose a finite number.");
	if (value < parameter.minimum)
		refuse(parameter, formatted(value), "choose " + formatted(parameter.minimum) + " or more.");
}

void checkEnumeration(const Parameter& parameter, int index) {
	if (index >= 0 && index < static_cast<int>(parameter.values.size()))
		return;
	std::string choices;
	for (std::size_t i = 0; i < parameter.values.size(); ++i)
		choices += (i > 0 ? ", " : "") + std::to_string(i) + " (" + parameter.values[i] + ")";
	refuse(parameter, std::to_string(index), "choose one of " + choices + ".");
}

void check(const Parameter& parameter, const ParameterValues& values) {
	switch (parameter.type) {
	case ParameterType::Int:
		checkNumber(parameter, values.integer(parameter.name));
		break;
	case ParameterType::Float:
	case ParameterType::Length:
		checkNumber(parameter, values.number(parameter.name));
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
	for (const Parameter& parameter : filter.parameters)
		check(parameter, call.values);
	call.log(filter.name);
	Results results = filter.run(call);
	for (const Result& result : results)
		call.log(logLine(result));
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
