/* SPDX-License-Identifier: GPL-3.0-or-later
   out_of_memory.c: stands before the C library's allocations for SuiteSparse, and in place of GKlib's error.c for
   METIS.

   That raises SIGABRT and leaves the signal's handler by a jump: the signal stays blocked, so that the second time
   METIS goes on with a null pointer; its handlers are the whole process's meanwhile; and what METIS allocates before
   they are set ends the process. Here the jump is taken at once, and a way back is there before METIS begins. */
#include "out_of_memory.h"

/* As GKlib asks for where its variables are defined. */
#define _GK_ERROR_C_
#include "metislib.h"

#define MOST_RETURNS 8

__thread int gk_cur_jbufs = -1;
__thread jmp_buf gk_jbufs[MOST_RETURNS];
__thread jmp_buf gk_jbuf;
static __thread int outOfMemory = 0;

void forgetOutOfMemory(void) {
	outOfMemory = 0;
}

void noteOutOfMemory(void) {
	outOfMemory = 1;
}

int wasOutOfMemory(void) {
	return outOfMemory;
}

static void* noted(void* pointer) {
	if (pointer == NULL)
		noteOutOfMemory();
	return pointer;
}

void* notedMalloc(size_t size) {
	return noted(malloc(size));
}

void* notedCalloc(size_t count, size_t size) {
	return noted(calloc(count, size));
}

void* notedRealloc(void* pointer, size_t size) {
	return noted(realloc(pointer, size));
}

int gk_sigtrap() {
	if (gk_cur_jbufs + 1 >= MOST_RETURNS)
		return 0;
	++gk_cur_jbufs;
	return 1;
}

int gk_siguntrap() {
	if (gk_cur_jbufs < 0)
		return 0;
	--gk_cur_jbufs;
	return 1;
}

void gk_errexit(int number, char* format, ...) {
	(void)format;
	if (gk_cur_jbufs < 0)
		abort();
	longjmp(gk_jbufs[gk_cur_jbufs], number);
}

/* Of an error that is none of memory. */
void errexit(char* format, ...) {
	gk_errexit(SIGERR, format);
}

/* What CHOLMOD calls in place of METIS_NodeND: an order in any case, if need be the one there is. */
int nodeNDOrIdentity(idx_t* count, idx_t* starts, idx_t* neighbours, idx_t* weights, idx_t* options, idx_t* order,
					 idx_t* inverse) {
	int result = METIS_ERROR_MEMORY;
	idx_t i;
	gk_sigtrap();
	if (gk_sigcatch() == 0)
		result = METIS_NodeND(count, starts, neighbours, weights, options, order, inverse);
	gk_siguntrap();
	if (result != METIS_OK)
		noteOutOfMemory();
	for (i = 0; result != METIS_OK && i < *count; ++i)
		order[i] = inverse[i] = i;
	return result;
}
