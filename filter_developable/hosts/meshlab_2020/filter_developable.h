// SPDX-License-Identifier: GPL-3.0-or-later
// filter_developable.h: the plugin as MeshLab 2020.09 sees it.
#pragma once

#include "../../filter_description.h"
#include "host_api.h"

/// Nothing may throw through this interface: the host would abort. meshlabserver prints the log and never an
/// error message, so errors go to both.
class FilterDevelopable : public QObject, public MeshFilterInterface {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
	Q_INTERFACES(MeshFilterInterface)

public:
	FilterDevelopable();

	QString pluginName() const override;
	QString filterName(FilterIDType id) const override;
	QString filterInfo(FilterIDType id) const override;
	FilterClass getClass(QAction* action) override;
	FILTER_ARITY filterArity(QAction* action) const override;
	int postCondition(QAction* action) const override;
	void initParameterSet(QAction* action, MeshDocument& document, RichParameterList& parameters) override;
	bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
					 vcg::CallBackPos* callback) override;

private:
	const developable::plugin::FilterDescription& filter(const QAction* action) const;

	const std::vector<developable::plugin::FilterDescription> filters_;
};
