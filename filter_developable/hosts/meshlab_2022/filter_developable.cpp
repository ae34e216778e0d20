// SPDX-License-Identifier: GPL-3.0-or-later
// filter_developable.cpp: the adapter to MeshLab 2022.02 and later.
#include "filter_developable.h"

#include "../../adapter.h"
#include "../../filters/filters.h"
#include "../../run_filter.h"

namespace plugin = developable::plugin;

FilterDevelopable::FilterDevelopable() : filters_(plugin::allFilters()) {
	for (std::size_t id = 0; id < filters_.size(); ++id) {
		typeList.push_back(static_cast<ActionIDType>(id));
		actionList.push_back(new QAction(plugin::toQString(filters_[id].name), this));
	}
}

const plugin::FilterDescription& FilterDevelopable::filter(const QAction* action) const {
	return filters_.at(std::size_t(ID(action)));
}

QString FilterDevelopable::pluginName() const {
	return "FilterDevelopable";
}

QString FilterDevelopable::vendor() const {
	return "Developable";
}

QString FilterDevelopable::filterName(ActionIDType id) const {
	return plugin::toQString(filters_.at(std::size_t(id)).name);
}

QString FilterDevelopable::pythonFilterName(ActionIDType id) const {
	return plugin::toQString(filters_.at(std::size_t(id)).pythonName);
}

QString FilterDevelopable::filterInfo(ActionIDType id) const {
	return plugin::toQString(filters_.at(std::size_t(id)).help);
}

FilterPlugin::FilterClass FilterDevelopable::getClass(const QAction* action) const {
	return plugin::menuClass(filter(action));
}

FilterPlugin::FilterArity FilterDevelopable::filterArity(const QAction*) const {
	// With SINGLE_MESH the window offers a preview, and when that is cancelled it restores what it knows of:
	// neither custom attributes nor layers that were added.
	return VARIABLE;
}

int FilterDevelopable::postCondition(const QAction* action) const {
	return plugin::changedElements(filter(action));
}

RichParameterList FilterDevelopable::initParameterList(const QAction* action, const MeshDocument& document) {
	return plugin::richParameters(filter(action), document);
}

std::map<std::string, QVariant> FilterDevelopable::applyFilter(const QAction* action,
															   const RichParameterList& parameters,
															   MeshDocument& document,
															   unsigned int& postConditionMask,
															   vcg::CallBackPos* callback) {
	try {
		const plugin::Results results = plugin::runOnDocument(filter(action), document, parameters, callback,
															  [this](const std::string& line) { log(line); });
		postConditionMask = static_cast<unsigned int>(postCondition(action));
		std::map<std::string, QVariant> returned;
		for (const plugin::Result& result : results)
			returned[result.key] = std::visit([](auto value) { return QVariant(value); }, result.value);
		return returned;
	} catch (...) {
		throw MLException(plugin::toQString(plugin::sentenceForCurrentException()));
	}
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterDevelopable)
