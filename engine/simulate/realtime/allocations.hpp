#pragma once

#include <cstdint>
#include <optional>

namespace stepwire::realtime {

/// Returns the count of memory requests of this thread so far.
///
/// Counted are malloc, calloc, realloc, aligned_alloc, posix_memalign, memalign and so new, in stepwire and
/// in libraries. A program that links this function has these functions of the C library replaced by ones
/// that count and forward. Returns std::nullopt with sanitizers, which replace them too, and with C libraries
/// other than glibc.
std::optional<std::int64_t> thread_allocations();

}  // namespace stepwire::realtime
