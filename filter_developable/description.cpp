// SPDX-License-Identifier: GPL-3.0-or-later
// description.cpp: what other programs are told of the filters, as JSON.
#include "description.h"

#include "adapter.h"
#include "departure.h"
#include "filters/filters.h"

#include "developable/mesh/mesh.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace developable::plugin {

namespace {

QString typeOf(const Parameter& parameter) {
	switch (parameter.type) {
	case ParameterType::Bool:
		return "bool";
	case ParameterType::Int:
		return "int";
	case ParameterType::Float:
		return "float";
	case ParameterType::Length:
		return "length";
	case ParameterType::Enumeration:
		return "enumeration";
	case ParameterType::Mesh:
		return "mesh";
	}
	return {};
}

QString nameOf(FilterClass filterClass) {
	switch (filterClass) {
	case FilterClass::Smoothing:
		return "Smoothing";
	case FilterClass::Quality:
		return "Quality";
	case FilterClass::Remeshing:
		return "Remeshing";
	case FilterClass::Texture:
		return "Texture";
	}
	return {};
}

QJsonValue defaultOf(const Parameter& parameter) {
	if (parameter.type == ParameterType::Bool)
		return parameter.defaultValue != 0;
	if (parameter.type == ParameterType::Enumeration)
		return toQString(parameter.values[std::size_t(parameter.defaultValue)]);
	return parameter.defaultValue;
}

/// JSON has no infinity.
QJsonValue finiteOrNull(double number) {
	return std::isfinite(number) ? QJsonValue(number) : QJsonValue();
}

QJsonObject describe(const Parameter& parameter) {
	QJsonArray choices;
	for (const std::string& value : parameter.values)
		choices.push_back(toQString(value));
	return {
		{"name", toQString(parameter.name)},
		{"type", typeOf(parameter)},
		{"default", defaultOf(parameter)},
		{"label", toQString(parameter.label)},
		{"tooltip", toQString(parameter.tooltip)},
		{"unit", toQString(parameter.unit)},
		{"minimum", finiteOrNull(parameter.range.minimum)},
		{"minimum_excluded", parameter.range.minimumExcluded},
		{"maximum", finiteOrNull(parameter.range.maximum)},
		{"automatic", parameter.automatic},
		{"choices", choices},
		{"only_for_solver", toQString(parameter.onlyForSolver)},
		{"positive_for_solver", toQString(parameter.positiveForSolver)},
	};
}

QJsonObject describe(const FilterDescription& filter) {
	QJsonArray parameters;
	for (const Parameter& parameter : filter.parameters)
		parameters.push_back(describe(parameter));
	return {
		{"name", toQString(filter.name)},
		{"python_name", toQString(filter.pythonName)},
		{"short_name", toQString(filter.shortName)},
		{"class", nameOf(filter.filterClass)},
		{"help", toQString(filter.help)},
		{"parameters", parameters},
	};
}

QJsonObject entry(int number, const char* name, const char* text) {
	return {{"number", number}, {"name", name}, {"text", text}};
}

QJsonObject describeAll() {
	QJsonArray filters, statuses, reasons, warnings;
	for (const FilterDescription& filter : allFilters())
		filters.push_back(describe(filter));
	for (const StatusProperties& known : statusProperties)
		statuses.push_back(entry(static_cast<int>(known.status), known.name, known.text));
	for (const ReasonProperties& known : reasonProperties)
		reasons.push_back(entry(static_cast<int>(known.reason), known.name, known.text));
	for (const Warning& known : departureWarnings)
		warnings.push_back(QJsonObject{{"key", known.key}, {"limit", known.limit}, {"text", known.text}});
	return {{"filters", filters},
			{"statuses", statuses},
			{"reasons", reasons},
			{"strain_left", strainLeftText},
			{"warnings", warnings}};
}

} // namespace

} // namespace developable::plugin

const char* developable_description() {
	static const QByteArray json = QJsonDocument(developable::plugin::describeAll()).toJson();
	return json.constData();
}
