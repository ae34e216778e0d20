// SPDX-License-Identifier: GPL-3.0-or-later
// prefetch.h: asking for memory before it is needed.
#pragma once

namespace developable::detail {

/// Starts to bring a cache line near, and changes nothing else.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
	__builtin_prefetch(address);
	asm volatile(""); // GCC leaves out calls of functions that do nothing but prefetch
#endif
}

} // namespace developable::detail
