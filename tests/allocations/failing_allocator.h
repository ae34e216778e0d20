// SPDX-License-Identifier: GPL-3.0-or-later
// failing_allocator.h: memory that comes to an end where a test wants it to.
#pragma once

namespace developable::test {

/// Which allocations of the process fail, counted from when they are armed: of C++ and of what is linked
/// statically, on all threads.
struct FailingAllocations {
	long first = 0; ///< the number of the first that fails, from 1; 0: none does
	long count = 1; ///< how many fail, that one included
};

/// \param fails  from now on
void arm(const FailingAllocations& fails);

/// \return how many allocations there were since arm(), failed ones included; none fails any more
long disarm();

} // namespace developable::test
