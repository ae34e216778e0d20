// SPDX-License-Identifier: GPL-3.0-or-later
// prefetch.h: asking for memory before it is needed.
#pragma once

namespace developable::detail {

/// Starts to bring a cache line near, and changes nothing else.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
	__builtin_prefetch(address);
#endif
}

} // namespace developable::detail
