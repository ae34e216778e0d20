// SPDX-License-Identifier: GPL-3.0-or-later
// report.cpp: the statuses in words.
#include "report.h"

namespace developable {

std::string describe(Status status) {
	switch (status) {
	case Status::Converged:
		return "converged";
	case Status::Stalled:
		return "stalled: further steps would change next to nothing";
	case Status::LimitReached:
		return "stopped at the limit of iterations or operations";
	case Status::NeedsCut:
		return "no developable shape near this one: it needs a cut";
	case Status::Stopped:
		return "stopped by the user: nothing was changed";
	case Status::NothingToDo:
		return "nothing to do: developable from the start";
	}
	return "unknown";
}

std::string describe(const OptimizationReport& report) {
	return report.reason.empty() ? describe(report.status) : report.reason;
}

} // namespace developable
