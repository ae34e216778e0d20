// SPDX-License-Identifier: GPL-3.0-or-later
// loaded_plugin.h: the plugin as its host loads it, called alike in every host, with a log to read.
#pragma once

#include "host.h"

#include <QPluginLoader>
#include <vcg/complex/allocate.h>

namespace developable::test {

#if DEVELOPABLE_HOST_YEAR == 2020
using EnumerationValue = EnumValue;
#else
using EnumerationValue = IntValue;
#endif

/// How a call of a filter ended.
struct Outcome {
	bool succeeded = false;
	QString error;   ///< what the host would show
	QStringList log; ///< one line each
};

class LoadedPlugin {
public:
	explicit LoadedPlugin(const QString& file) : loader_(file) {
		plugin_ = qobject_cast<plugin::host::Interface*>(loader_.instance());
	}

	/// Empty when the plugin was loaded.
	QString whyNot() const { return plugin_ != nullptr ? QString() : loader_.errorString(); }

	RichParameterList parameters(const QString& filter, MeshDocument& document) {
#if DEVELOPABLE_HOST_YEAR == 2020
		RichParameterList list;
		plugin_->initParameterSet(action(filter), document, list);
		return list;
#else
		return plugin_->initParameterList(action(filter), static_cast<const MeshDocument&>(document));
#endif
	}

	/// Whether the host's window offers a preview of it: for what changes one mesh and no connectivity.
	bool hasPreview(const QString& filter) {
		const auto changed = unsigned(plugin_->postCondition(action(filter)));
		const unsigned connectivity = MeshModel::MM_VERTNUMBER | MeshModel::MM_FACENUMBER;
		return plugin_->filterArity(action(filter)) == plugin::host::Interface::SINGLE_MESH &&
			   (changed & connectivity) == 0;
	}

	QStringList filters() const {
		QStringList names;
		for (const QAction* action : plugin_->actions())
			names.push_back(action->text());
		return names;
	}

	/// Calls a filter as the host does.
	Outcome apply(const QString& filter, MeshDocument& document, const RichParameterList& parameters,
				  vcg::CallBackPos* callback) {
		GLLogStream log;
		plugin_->setLog(&log);
		Outcome outcome;
#if DEVELOPABLE_HOST_YEAR == 2020
		outcome.succeeded = plugin_->applyFilter(action(filter), document, parameters, callback);
		if (!outcome.succeeded)
			outcome.error = plugin_->errorMsg();
#else
		try {
			unsigned int changed = 0;
			plugin_->applyFilter(action(filter), parameters, document, changed, callback);
			outcome.succeeded = true;
		} catch (const MLException& exception) {
			outcome.error = exception.what();
		}
#endif
		plugin_->setLog(nullptr);
		log.print(outcome.log);
		return outcome;
	}

private:
	QAction* action(const QString& filter) {
		for (QAction* candidate : plugin_->actions())
			if (candidate->text() == filter)
				return candidate;
		qFatal("the plugin has no filter %s", qUtf8Printable(filter));
	}

	QPluginLoader loader_;
	plugin::host::Interface* plugin_ = nullptr;
};

} // namespace developable::test
