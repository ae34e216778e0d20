// SPDX-License-Identifier: GPL-3.0-or-later
// memory.h: how much memory a computation may take.
#pragma once

#include <fstream>
#include <limits>
#include <string>

namespace developable::detail {

/// What the machine can give without swapping, bytes; infinite where it does not say (only Linux does).
inline double availableMemory() {
	std::ifstream file("/proc/meminfo");
	std::string name;
	for (double kilobytes = 0; file >> name >> kilobytes; file.ignore(80, '\n'))
		if (name == "MemAvailable:")
			return 1024 * kilobytes;
	return std::numeric_limits<double>::infinity();
}

} // namespace developable::detail
