// SPDX-License-Identifier: GPL-3.0-or-later
// pace_of_looks.h: how often a thread that waits for others looks how far they are.
#pragma once

#include <chrono>

namespace developable {

constexpr std::chrono::milliseconds betweenLooks(20);

} // namespace developable
