#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

// For one target's only file: a length in a message that lies asks for more than there is. roscpp
// resizes first and reads then; the std::bad_alloc that it catches costs it that message.
constexpr size_t kMaxAllocation = 256u << 20;

void* operator new(size_t size) {
  void* const memory = size <= kMaxAllocation ? std::malloc(size) : nullptr;
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new(size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
