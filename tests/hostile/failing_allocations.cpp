// SPDX-License-Identifier: GPL-3.0-or-later
// failing_allocations.cpp: to be preloaded; stands before the C library's allocation and makes some fail.
//
// Of the environment's variables FAILING_IN says where allocations are counted, from the start: in processes
// whose command line has this text, or, when it is `fork`, in what is forked. FAILING_FIRST is the number of
// the first to fail, from 1, and FAILING_COUNT how many do. FAILING_LOG names a file that grows by a byte at
// each thousandth.
#include "support/failing_range.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace {

developable::test::FailingRange allocations;
int logFile = -1;

bool fails() {
	const long number = allocations.next();
	if (number > 0 && number % 1000 == 0 && logFile >= 0)
		static_cast<void>(!write(logFile, "+", 1));
	return allocations.fails(number);
}

long variable(const char* name) {
	const char* text = std::getenv(name);
	return text == nullptr ? 0 : std::atol(text);
}

void count() {
	allocations.begin();
}

bool commandLineHas(const char* text) {
	char line[4096] = {};
	const int file = open("/proc/self/cmdline", O_RDONLY);
	const ssize_t length = file < 0 ? 0 : read(file, line, sizeof(line) - 1);
	close(file);
	for (ssize_t i = 0; i < length; ++i)
		if (line[i] == 0)
			line[i] = ' ';
	return std::strstr(line, text) != nullptr;
}

__attribute__((constructor)) void begin() {
	const char* where = std::getenv("FAILING_IN");
	if (where == nullptr)
		return;
	allocations.set(variable("FAILING_FIRST"), variable("FAILING_COUNT"));
	if (const char* name = std::getenv("FAILING_LOG"); name != nullptr)
		logFile = open(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
	if (std::strcmp(where, "fork") == 0)
		pthread_atfork(nullptr, nullptr, count);
	else if (commandLineHas(where))
		count();
}

} // namespace

extern "C" {

// glibc's own names, which need not be looked up: that would allocate.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* pointer, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
	return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
	return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* pointer, std::size_t size) {
	return fails() ? nullptr : __libc_realloc(pointer, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
	return fails() ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** pointer, std::size_t alignment, std::size_t size) {
	*pointer = fails() ? nullptr : __libc_memalign(alignment, size);
	return *pointer == nullptr ? ENOMEM : 0;
}
}
