#pragma once

#include <cstdint>
#include <optional>

namespace stepwire::realtime {

/// How often this thread has asked for memory so far, by malloc, calloc, realloc, aligned_alloc,
/// posix_memalign or memalign, and so by new, from our code or any library. A program that calls this
/// function has these functions of the C library replaced by ones that count and pass on. Nothing where that
/// is not done: with sanitizers, which replace them too, and with other C libraries than glibc.
std::optional<std::int64_t> thread_allocations();

}  // namespace stepwire::realtime
