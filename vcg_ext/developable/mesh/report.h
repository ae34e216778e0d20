// SPDX-License-Identifier: GPL-3.0-or-later
// report.h: what an optimisation says about its run.
#pragma once

#include <string>

namespace developable {

/// Why a run ended. The numbers are part of the interface.
enum class Status {
	Converged =
		0, ///< every vertex copy is a developable point (and C is below its tolerance, where one is set)
	Stalled = 1,      ///< further steps would change nothing worth having
	LimitReached = 2, ///< the limit of iterations or operations
	NeedsCut = 3,     ///< there is no developable shape near this one: it needs a cut
	Stopped = 4,      ///< the user asked for a stop; nothing was changed
	NothingToDo = 5   ///< developable from the start
};

/// What every optimisation reports. Shapes are compared by the caller, which has both of them.
struct OptimizationReport {
	Status status = Status::NothingToDo;
	long iterations = 0; ///< outer steps of the global methods, operations attempted of the local method
	std::string reason;  ///< for the status, in a few words, where there is more to say than it does
};

/// True when the run ended in a developable shape, as that method's tolerances have it.
inline bool converged(Status status) {
	return status == Status::Converged || status == Status::NothingToDo;
}

/// The status in a few words.
std::string describe(Status status);

/// The status in a few words, for the reason that the run gave.
std::string describe(const OptimizationReport& report);

} // namespace developable
