// SPDX-License-Identifier: GPL-3.0-or-later
// adapter.cpp: descriptions to host types, host values to filters.
#include "adapter.h"

#include "host_progress.h"
#include "layer.h"
#include "run_filter.h"

#include "developable/mesh/mesh.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <charconv>

namespace developable::plugin {

namespace {

QStringList toQStrings(const std::vector<std::string>& texts) {
	QStringList list;
	for (const std::string& text : texts)
		list.push_back(toQString(text));
	return list;
}

/// The length that 100 % stands for.
double referenceLength(const MeshModel* layer) {
	const double diagonal = layer != nullptr ? double(layer->cm.bbox.Diag()) : 0;
	return diagonal > 0 ? diagonal : 1;
}

/// Whether a layer has vertex colours to lose. Some hosts give every mesh a colour, one for all its vertices.
bool isColoured(const MeshModel* layer) {
	if (layer == nullptr || !layer->hasDataMask(MeshModel::MM_VERTCOLOR))
		return false;
	const auto& vertices = layer->cm.vert;
	return std::any_of(vertices.begin(), vertices.end(), [&vertices](const CVertexO& vertex) {
		return !vertex.IsD() && vertex.cC() != vertices.front().cC();
	});
}

/// With its unit, but of a length: the dialog shows that in two units, the mesh's and percent.
QString shownLabel(const Parameter& parameter) {
	if (parameter.unit.empty() || parameter.type == ParameterType::Length)
		return toQString(parameter.label);
	return toQString(parameter.label + " (" + parameter.unit + ")");
}

void add(RichParameterList& list, const Parameter& parameter, host::ReadDocument& document) {
	const QString name = toQString(parameter.name), label = shownLabel(parameter),
				  tooltip = toQString(parameter.tooltip);
	const auto scalar = static_cast<host::Scalar>(parameter.defaultValue);
	const auto integer = static_cast<int>(parameter.defaultValue);
	switch (parameter.type) {
	case ParameterType::Bool: {
		const bool isOff = parameter.offWhenColoured && isColoured(document.mm());
		list.addParam(RichBool(name, integer != 0 && !isOff, label, tooltip));
		break;
	}
	case ParameterType::Int:
		list.addParam(RichInt(name, integer, label, tooltip));
		break;
	case ParameterType::Float:
		list.addParam(RichFloat(name, scalar, label, tooltip));
		break;
	case ParameterType::Length: {
		const auto full = static_cast<host::Scalar>(referenceLength(document.mm()));
		list.addParam(host::LengthParameter(name, scalar, 0, full, label, tooltip));
		break;
	}
	case ParameterType::Enumeration:
		list.addParam(RichEnum(name, integer, toQStrings(parameter.values), label, tooltip));
		break;
	case ParameterType::Mesh:
		list.addParam(host::layerParameter(name, document, label, tooltip));
		break;
	}
}

/// Hosts keep some numbers in float, where a script's 1e-4 is 9.99999975e-05. What was meant is the shortest
/// decimal number that gives the same float.
double asTyped(double number) {
	const auto single = static_cast<float>(number);
	if (double(single) != number)
		return number;
	std::array<char, 32> text;
	const auto end = std::to_chars(text.data(), text.data() + text.size(), single).ptr;
	double typed = number;
	std::from_chars(text.data(), end, typed);
	return typed;
}

/// A layer's name without a file's ending, and without dots: windows show only what stands before one.
QString shownName(QString label) {
	static const QRegularExpression ending("\\.(?=[0-9]*[A-Za-z])[A-Za-z0-9]{2,4}$");
	return label.remove(ending).replace('.', '_');
}

const CMeshO* chosenMesh(const Parameter& parameter, const RichParameterList& list,
						 const MeshDocument& document) {
	const MeshModel* layer = host::chosenLayer(list, toQString(parameter.name), document);
	if (layer == nullptr)
		throw InvalidParameter("The parameter '" + parameter.name +
							   "' names a layer that is not there: choose one of the document's.");
	return &layer->cm;
}

ParameterValues::Value valueOf(const Parameter& parameter, const RichParameterList& list,
							   const MeshDocument& document) {
	const QString name = toQString(parameter.name);
	switch (parameter.type) {
	case ParameterType::Bool:
		return list.getBool(name);
	case ParameterType::Int:
		return list.getInt(name);
	case ParameterType::Float:
		return asTyped(double(list.getFloat(name)));
	case ParameterType::Length:
		return asTyped(double(list.getAbsPerc(name)));
	case ParameterType::Enumeration:
		return list.getEnum(name);
	case ParameterType::Mesh:
		return chosenMesh(parameter, list, document);
	}
	return false;
}

} // namespace

QString toQString(const std::string& text) {
	return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

RichParameterList richParameters(const FilterDescription& filter, host::ReadDocument& document) {
	RichParameterList list;
	for (const Parameter& parameter : filter.parameters)
		add(list, parameter, document);
	return list;
}

host::Interface::FilterClass menuClass(const FilterDescription& filter) {
	switch (filter.filterClass) {
	case FilterClass::Smoothing:
		return host::Interface::Smoothing;
	case FilterClass::Quality:
		return host::Interface::Quality;
	case FilterClass::Remeshing:
		return host::Interface::Remeshing;
	case FilterClass::Texture:
		return host::Interface::Texture;
	}
	return host::Interface::Generic;
}

int changedElements(const FilterDescription& filter) {
	const int shown = MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR;
	const int moved = MeshModel::MM_VERTCOORD | MeshModel::MM_VERTNORMAL | MeshModel::MM_FACENORMAL;
	switch (filter.change) {
	case Change::Positions:
		return shown | moved;
	case Change::Scalars:
		return shown;
	case Change::Panels:
		return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE | MeshModel::MM_FACEQUALITY |
			   MeshModel::MM_FACECOLOR;
	case Change::Faces:
		return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
	case Change::TextureCoordinates:
		return shown | MeshModel::MM_WEDGTEXCOORD;
	}
	return MeshModel::MM_ALL;
}

Results runOnDocument(const FilterDescription& filter, MeshDocument& document,
					  const RichParameterList& parameters, vcg::CallBackPos* callback,
					  const std::function<void(const std::string& line)>& log) {
	if (document.mm() == nullptr)
		throw EmptyMesh("There is no mesh: open one first.");
	Layer layer(*document.mm());
	const auto addLayer = [&document, name = shownName(document.mm()->label())](const std::string& suffix) {
		return Layer(*document.addNewMesh(QString(), (name + toQString(suffix)).trimmed(), true));
	};
	FilterCall call{layer, {}, hostProgress(callback), log, addLayer};
	for (const Parameter& parameter : filter.parameters)
		call.values.set(parameter.name, valueOf(parameter, parameters, document));
	return runFilter(filter, call);
}

} // namespace developable::plugin
