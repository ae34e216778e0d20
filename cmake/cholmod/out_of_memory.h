/* SPDX-License-Identifier: GPL-3.0-or-later
   out_of_memory.h: whether CHOLMOD and METIS had all the memory that they asked for. What they return doesn't
   say: CHOLMOD forgets some of its failures and doesn't look at METIS'. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/* Before a call of CHOLMOD. */
void forgetOutOfMemory(void);

/* An allocation has failed. */
void noteOutOfMemory(void);

/* Whether an allocation has failed since, on this thread: then nothing that the call has made is any good. */
int wasOutOfMemory(void);

#ifdef __cplusplus
}
#endif
