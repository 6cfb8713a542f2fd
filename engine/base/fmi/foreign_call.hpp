#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/base/math/floating_point.hpp"

namespace stepwire::fmi {

/// The call into a unit that is under way. Another thread, or another process, reads it where a call hangs.
struct CallNote {
  static constexpr std::size_t room = 44;

  std::atomic<std::uint32_t> count{0};  ///< of beginnings and ends: odd while a call is under way
  char name[room] = "";

  bool under_way() const { return count.load(std::memory_order_relaxed) % 2 == 1; }
  /// "fmi3DoStep"; empty before the first call.
  std::string text() const;
};

/// A call into a unit lasts for its scope: the note names it, and behind it the floating-point state of this
/// thread is as before.
class ForeignCall {
 public:
  ForeignCall(CallNote& note, const char* name);
  ~ForeignCall() { count(); }
  ForeignCall(const ForeignCall&) = delete;
  ForeignCall& operator=(const ForeignCall&) = delete;

 private:
  /// One thread at a time calls the functions of an instance.
  void count() {
    note_.count.store(note_.count.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  CallNote& note_;
  FloatingPointState state_{};
};

}  // namespace stepwire::fmi
