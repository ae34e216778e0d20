// SPDX-License-Identifier: GPL-3.0-or-later
// progress.cpp: parts of a run, and runs that begin again.
#include "progress.h"

#include <algorithm>
#include <memory>

namespace developable {

Progress partOf(const Progress& progress, double begin, double end, const std::string& prefix) {
	if (!progress)
		return {};
	return [=](double fraction, const std::string& message) {
		return progress(begin + fraction * (end - begin), prefix + message);
	};
}

Progress neverBack(const Progress& progress) {
	if (!progress)
		return {};
	struct Said {
		double most = 0;
		bool stop = false;
	};
	return [progress, said = std::make_shared<Said>()](double fraction, const std::string& message) {
		said->most = std::max(said->most, fraction);
		said->stop = said->stop || !progress(said->most, message);
		return !said->stop;
	};
}

} // namespace developable
