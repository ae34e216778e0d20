// SPDX-License-Identifier: GPL-3.0-or-later
// host_progress.h: passes a run's progress on to the host's callback.
#pragma once

#include "developable/mesh/mesh.h"

#include <cstring> // vcglib 2020.09 forgets it
#include <wrap/callback.h>

namespace developable::plugin {

/// A progress function that calls the host at most twenty times a second; once the host has asked for a stop,
/// it does not ask again. After a second it also says how long the rest takes at the pace so far. A null
/// callback never stops.
Progress hostProgress(vcg::CallBackPos* callback);

} // namespace developable::plugin
