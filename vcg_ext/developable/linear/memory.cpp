// SPDX-License-Identifier: GPL-3.0-or-later
// memory.cpp: asks the system how much memory there is.
#include "memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace developable {

double availableMemory() {
	std::ifstream file("/proc/meminfo");
	std::string name;
	for (double kilobytes = 0; file >> name >> kilobytes; file.ignore(80, '\n'))
		if (name == "MemAvailable:")
			return 1024 * kilobytes;
	return std::numeric_limits<double>::infinity();
}

} // namespace developable
