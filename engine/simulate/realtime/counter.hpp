#pragma once

#include <atomic>
#include <cstdint>

namespace stepwire::realtime {

/// Counter that one thread increments and others may read concurrently. It is as cheap as a plain number,
/// because its accesses order no others. A copy has its present value.
class Counter {
 public:
  Counter(std::int64_t value = 0) : value_(value) {}
  Counter(const Counter& other) : value_(other.get()) {}
  Counter& operator=(const Counter& other) {
    set(other.get());
    return *this;
  }

  std::int64_t get() const { return value_.load(std::memory_order_relaxed); }
  operator std::int64_t() const { return get(); }

  /// Only for the thread that counts.
  void set(std::int64_t value) { value_.store(value, std::memory_order_relaxed); }
  void add(std::int64_t more = 1) { set(get() + more); }

 private:
  std::atomic<std::int64_t> value_;
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
};

}  // namespace stepwire::realtime
