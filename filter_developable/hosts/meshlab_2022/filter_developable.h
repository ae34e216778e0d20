// SPDX-License-Identifier: GPL-3.0-or-later
// filter_developable.h: the plugin as MeshLab 2022.02 and later see it.
#pragma once

#include "../../filter_description.h"
#include "host_api.h"

class FilterDevelopable : public QObject, public FilterPlugin {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
	Q_INTERFACES(FilterPlugin)

public:
	FilterDevelopable();

	QString pluginName() const override;
	QString vendor() const override;
	QString filterName(ActionIDType id) const override;
	QString pythonFilterName(ActionIDType id) const override;
	QString filterInfo(ActionIDType id) const override;
	FilterClass getClass(const QAction* action) const override;
	FilterArity filterArity(const QAction* action) const override;
	int postCondition(const QAction* action) const override;
	RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;
	std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
												MeshDocument& document, unsigned int& postConditionMask,
												vcg::CallBackPos* callback) override;

private:
	const developable::plugin::FilterDescription& filter(const QAction* action) const;

	const std::vector<developable::plugin::FilterDescription> filters_;
};
