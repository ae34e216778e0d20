/* SPDX-License-Identifier: GPL-3.0-or-later
   thread_local_statics.h: stands before GKlib's random.c, whose row of random numbers is the whole process's: here
   each thread has its own, so that threads may look for orders of elimination at once, and each finds the same on
   every run. */
#include <GKlib.h>

#define static static __thread
