// SPDX-License-Identifier: GPL-3.0-or-later
// filter_developable.cpp: the adapter to MeshLab 2020.09.
#include "filter_developable.h"

#include "../../adapter.h"
#include "../../filters/filters.h"
#include "../../run_filter.h"

namespace plugin = developable::plugin;

FilterDevelopable::FilterDevelopable() : filters_(plugin::allFilters()) {
	for (std::size_t id = 0; id < filters_.size(); ++id) {
		typeList.push_back(static_cast<FilterIDType>(id));
		actionList.push_back(new QAction(plugin::toQString(filters_[id].name), this));
	}
}

const plugin::FilterDescription& FilterDevelopable::filter(const QAction* action) const {
	return filters_[std::size_t(ID(const_cast<QAction*>(action)))];
}

QString FilterDevelopable::pluginName() const {
	return "FilterDevelopable";
}

QString FilterDevelopable::filterName(FilterIDType id) const {
	return plugin::toQString(filters_.at(std::size_t(id)).name);
}

QString FilterDevelopable::filterInfo(FilterIDType id) const {
	return plugin::toQString(filters_.at(std::size_t(id)).help);
}

MeshFilterInterface::FilterClass FilterDevelopable::getClass(QAction* action) {
	return plugin::menuClass(filter(action));
}

MeshFilterInterface::FILTER_ARITY FilterDevelopable::filterArity(QAction*) const {
	// With SINGLE_MESH the window offers a preview, and when that is cancelled it restores what it knows of:
	// neither custom attributes nor layers that were added.
	return VARIABLE;
}

int FilterDevelopable::postCondition(QAction* action) const {
	return plugin::changedElements(filter(action));
}

void FilterDevelopable::initParameterSet(QAction* action, MeshDocument& document,
										 RichParameterList& parameters) {
	parameters.join(plugin::richParameters(filter(action), document));
}

bool FilterDevelopable::applyFilter(QAction* action, MeshDocument& document,
									const RichParameterList& parameters, vcg::CallBackPos* callback) {
	try {
		plugin::runOnDocument(filter(action), document, parameters, callback,
							  [this](const std::string& line) { Log(line); });
		return true;
	} catch (...) {
		const std::string sentence = plugin::sentenceForCurrentException();
		errorMessage = plugin::toQString(sentence);
		Log(sentence);
		return false;
	}
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterDevelopable)
