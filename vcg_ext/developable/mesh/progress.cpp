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
	return [progress, most = std::make_shared<double>(0)](double fraction, const std::string& message) {
		*most = std::max(*most, fraction);
		return progress(*most, message);
	};
}

} // namespace developable
