// SPDX-License-Identifier: GPL-3.0-or-later
// memory.h: how much memory a computation may take.
#pragma once

namespace developable {

/// What the machine can give without swapping, bytes; infinite where it does not say (only Linux does).
double availableMemory();

} // namespace developable
