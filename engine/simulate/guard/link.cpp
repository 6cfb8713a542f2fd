#include "engine/simulate/guard/link.hpp"

#include <fmt/format.h>
#include <linux/futex.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <ctime>
#include <new>
#include <utility>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::guard {

namespace {

constexpr std::int64_t second = 1'000'000'000;
constexpr int most_tries = 1000;

template <std::size_t size>
void put_text(std::array<char, size>& to, const std::string& text) {
  const std::size_t count = std::min(text.size(), size - 1);
  std::memcpy(to.data(), text.data(), count);
  to[count] = '\0';
}

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

[[noreturn]] void fail() {
  throw io::EnvironmentError(fmt::format("memory for the guard is refused: {}", std::strerror(errno)));
}

}  // namespace

std::int64_t monotonic() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * second + time.tv_nsec;
}

void SharedNumbers::begin() noexcept {
  lock_.store(lock_.load(std::memory_order_relaxed) | 1u, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);
}

void SharedNumbers::put(const double* values) noexcept {
  begin();
  for (std::size_t i = 0; i < count_; ++i) values_[i].store(values[i], std::memory_order_relaxed);
  lock_.store(lock_.load(std::memory_order_relaxed) + 1u, std::memory_order_release);
}

bool SharedNumbers::get(double* values) const noexcept {
  for (int tries = 0; tries < most_tries; ++tries) {
    const std::uint32_t before = lock_.load(std::memory_order_acquire);
    if (before & 1u) continue;
    for (std::size_t i = 0; i < count_; ++i) values[i] = values_[i].load(std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_acquire);
    if (lock_.load(std::memory_order_relaxed) == before) return true;
  }
  return false;
}

Link::Link(std::size_t inputs, std::size_t outputs, std::string_view call)
    : memory_(::memfd_create("stepwire-guard", MFD_CLOEXEC)) {
  const std::size_t bytes = sizeof(Head) + (inputs + outputs) * sizeof(double) + call.size();
  if (!memory_.open() || ::ftruncate(memory_.number(), static_cast<off_t>(bytes)) != 0) fail();
  map(bytes);
  ::new (head_) Head();
  head_->loop = ::getpid();
  head_->inputs = inputs;
  head_->outputs = outputs;
  head_->call = call.size();
  std::memcpy(reinterpret_cast<char*>(head_) + call_offset(), call.data(), call.size());
}

Link::Link(io::Descriptor memory) : memory_(std::move(memory)) {
  struct stat status {};
  if (::fstat(memory_.number(), &status) != 0 || status.st_size < static_cast<off_t>(sizeof(Head))) fail();
  map(static_cast<std::size_t>(status.st_size));
  if (call_offset() + head_->call != bytes_)
    throw io::EnvironmentError("the memory of the guard has another layout");
}

Link::~Link() {
  if (head_) ::munmap(head_, bytes_);
}

void Link::map(std::size_t bytes) {
  void* const memory =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, memory_.number(), 0);
  if (memory == MAP_FAILED) fail();
  head_ = static_cast<Head*>(memory);
  bytes_ = bytes;
}

std::atomic<double>* Link::numbers() const {
  return reinterpret_cast<std::atomic<double>*>(reinterpret_cast<char*>(head_) + sizeof(Head));
}

std::size_t Link::call_offset() const {
  return sizeof(Head) + (head_->inputs + head_->outputs) * sizeof(double);
}

std::string_view Link::call() const {
  return {reinterpret_cast<const char*>(head_) + call_offset(), head_->call};
}

void Link::beat(GuardRequest request) noexcept {
  head_->request.store(static_cast<std::uint32_t>(request), std::memory_order_relaxed);
  head_->processor.store(::sched_getcpu(), std::memory_order_relaxed);
  head_->beats.fetch_add(1);
  if (head_->asleep.load() != 0)
    ::syscall(SYS_futex, &head_->beats, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

/// `asleep` is set before the beats are compared, and beat() counts before it reads `asleep`; so no beat is
/// missed.
void Link::await_beat(std::uint32_t seen, std::int64_t until) noexcept {
  const timespec time{static_cast<std::time_t>(until / second), static_cast<long>(until % second)};
  head_->asleep.store(1);
  // FUTEX_WAIT_BITSET takes an absolute time of CLOCK_MONOTONIC.
  ::syscall(SYS_futex, &head_->beats, FUTEX_WAIT_BITSET, seen, &time, nullptr, FUTEX_BITSET_MATCH_ANY);
  head_->asleep.store(0);
}

void Link::look_for_beat(std::uint32_t seen, std::int64_t until) const noexcept {
  while (beats() == seen && head_->processor.load(std::memory_order_relaxed) != ::sched_getcpu() &&
         monotonic() < until)
    pause();
}

void Link::tell(GuardState state, const std::string& reason) noexcept {
  if (!reason.empty()) put_text(head_->reason, reason);
  head_->state.store(static_cast<std::uint32_t>(state), std::memory_order_release);
}

void Link::put_reports(const std::string& lines) noexcept {
  put_text(head_->reports, lines);
}

}  // namespace stepwire::guard
