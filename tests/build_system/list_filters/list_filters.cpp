// SPDX-License-Identifier: GPL-3.0-or-later
// list_filters.cpp: loads a plugin with MeshLab's own loader and prints its filters, one Python name a line.

#include <common/plugins/plugin_manager.h>

#include <QApplication>

#include <cstdio>

int main(int argumentCount, char** arguments) {
	const QApplication application(argumentCount, arguments);
	PluginManager plugins;
	try {
		plugins.loadPlugin(arguments[1]);
	} catch (const MLException& error) {
		std::fprintf(stderr, "%s\n", error.what());
		return 1;
	}
	for (FilterPlugin* plugin : plugins.filterPluginIterator())
		for (const QAction* action : plugin->actions())
			std::printf("%s\n", qUtf8Printable(plugin->pythonFilterName(action)));
}
