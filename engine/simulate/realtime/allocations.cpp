#include "engine/simulate/realtime/allocations.hpp"

#include <cerrno>
#include <cstdlib>

#if defined(__has_feature)
#define STEPWIRE_CLANG_SANITIZES (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define STEPWIRE_CLANG_SANITIZES 0
#endif

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !STEPWIRE_CLANG_SANITIZES

namespace {

thread_local std::int64_t count = 0;  // a plain counter, which never allocates

}  // namespace

extern "C" {

// Names under which glibc offers the same functions to replacements.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
  ++count;
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++count;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++count;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++count;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  ++count;
  if (alignment < sizeof(void*) || (alignment & (alignment - 1)) != 0) return EINVAL;
  void* const got = __libc_memalign(alignment, size);
  if (!got) return ENOMEM;
  *memory = got;
  return 0;
}

}  // extern "C"

namespace stepwire::realtime {

std::optional<std::int64_t> thread_allocations() {
  return count;
}

}  // namespace stepwire::realtime

#else

namespace stepwire::realtime {

std::optional<std::int64_t> thread_allocations() {
  return std::nullopt;
}

}  // namespace stepwire::realtime

#endif
