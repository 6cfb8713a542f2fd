#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/base/math/floating_point.hpp"

namespace stepwire::fmi {

/// Name and state of the current call into a unit. Another thread or process reads it where a call hangs.
struct CallNote {
  static constexpr std::size_t room = 44;

  std::atomic<std::uint32_t> count{0};  ///< number of call entries and exits: odd during a call
  char name[room] = "";

  bool under_way() const { return count.load(std::memory_order_relaxed) % 2 == 1; }
  /// Returns the name of the last call, such as "fmi3DoStep"; empty before the first one.
  std::string text() const;
};

/// Scope guard of a call into a unit: it records the name, and its destructor restores the floating-point
/// state of this thread.
class ForeignCall {
 public:
  ForeignCall(CallNote& note, const char* name);
  ~ForeignCall() { count(); }
  ForeignCall(const ForeignCall&) = delete;
  ForeignCall& operator=(const ForeignCall&) = delete;

 private:
  /// Counts without a read-modify-write: only one thread at a time calls the functions of an instance.
  void count() {
    note_.count.store(note_.count.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  CallNote& note_;
  FloatingPointState state_{};
};

}  // namespace stepwire::fmi
