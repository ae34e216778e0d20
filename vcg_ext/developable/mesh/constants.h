// SPDX-License-Identifier: GPL-3.0-or-later
// constants.h: π in double precision (Eigen's own is a long double).
#pragma once

namespace developable {

inline constexpr double pi = 3.14159265358979323846;

} // namespace developable
