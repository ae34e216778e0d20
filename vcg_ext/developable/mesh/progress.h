// SPDX-License-Identifier: GPL-3.0-or-later
// progress.h: how a long run says where it is, and how a user asks it to stop.
#pragma once

#include <functional>
#include <string>

namespace developable {

/// Called now and then during a run with the share of the work that is done (0 to 1) and what is going on, in
/// words. Returns false to ask for a stop: the run then ends soon and leaves the positions as they were.
using Progress = std::function<bool(double fractionDone, const std::string& message)>;

/// True when the run may go on. A run without a progress function always may.
inline bool mayGoOn(const Progress& progress, double fractionDone, const std::string& message) {
	return !progress || progress(fractionDone, message);
}

/// For a part of a run: what that says counts as the part of the whole from begin to end, 0 to 1.
/// \param prefix  of its messages
Progress partOf(const Progress& progress, double begin, double end, const std::string& prefix = "");

/// For a run whose parts may begin again: what is done never gets less, and a stop holds for all of them.
Progress neverBack(const Progress& progress);

} // namespace developable
