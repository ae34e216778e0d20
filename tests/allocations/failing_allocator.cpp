// SPDX-License-Identifier: GPL-3.0-or-later
// failing_allocator.cpp: stands before malloc and its like (the linker's option --wrap leads calls here), and
// in place of operator new, whose own calls of malloc are in a shared library that the linker leaves alone.
#include "failing_allocator.h"

#include "support/failing_range.h"

#include <cstdlib>
#include <new>

// The names are the linker's. NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* pointer, std::size_t size);
}

namespace {

developable::test::FailingRange allocations;

bool fails() {
	return allocations.fails(allocations.next());
}

} // namespace

extern "C" {

void* __wrap_malloc(std::size_t size) {
	return fails() ? nullptr : __real_malloc(size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
	return fails() ? nullptr : __real_calloc(count, size);
}

void* __wrap_realloc(void* pointer, std::size_t size) {
	return fails() ? nullptr : __real_realloc(pointer, size);
}
}
// NOLINTEND(bugprone-reserved-identifier)

void* operator new(std::size_t size) {
	if (void* const pointer = std::malloc(size > 0 ? size : 1))
		return pointer;
	throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment) {
	void* pointer = nullptr;
	if (!fails() && posix_memalign(&pointer, static_cast<std::size_t>(alignment), size) == 0)
		return pointer;
	throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
	return std::malloc(size > 0 ? size : 1); // the sanitizers' own would not come to the one above
}

void operator delete(void* pointer) noexcept {
	std::free(pointer);
}
void operator delete(void* pointer, std::size_t /*size*/) noexcept {
	std::free(pointer);
}
void operator delete(void* pointer, const std::nothrow_t& /*unused*/) noexcept {
	std::free(pointer);
}
void operator delete(void* pointer, std::align_val_t /*alignment*/) noexcept {
	std::free(pointer);
}
void operator delete(void* pointer, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
	std::free(pointer);
}

namespace developable::test {

void arm(const FailingAllocations& which) {
	allocations.set(which.first, which.count);
	allocations.begin();
}

long disarm() {
	return allocations.end();
}

} // namespace developable::test
