#pragma once

#include <cfenv>
#include <cstdint>

namespace stepwire {

/// Scope guard of this thread's floating-point state: rounding mode, handling of denormals and exception
/// masks. Its destructor restores them after foreign code. On x86-64 it writes the control registers only
/// where they differ and keeps the raised flags, since fesetenv() takes 150 ns there.
class FloatingPointState {
 public:
  FloatingPointState() { read(before_); }
  ~FloatingPointState() { restore(); }
  FloatingPointState(const FloatingPointState&) = delete;
  FloatingPointState& operator=(const FloatingPointState&) = delete;

  /// Sets the initial state of a program: round to nearest, denormals kept, all exceptions masked.
  static void set_usual() {
#if defined(__x86_64__)
    write({0x1f80, 0x037f});
#else
    std::fesetenv(FE_DFL_ENV);
#endif
  }

 private:
#if defined(__x86_64__)
  struct Control {
    std::uint32_t vector;  ///< MXCSR
    std::uint16_t x87;
  };
  static constexpr std::uint32_t flags = 0x3f;  ///< of MXCSR: raised exceptions

  static void read(Control& control) {
    asm volatile("stmxcsr %0\n\tfnstcw %1" : "=m"(control.vector), "=m"(control.x87)::"memory");
  }
  static void write(const Control& control) {
    asm volatile("ldmxcsr %0\n\tfldcw %1" ::"m"(control.vector), "m"(control.x87) : "memory");
  }
  void restore() {
    Control now;
    read(now);
    if (((now.vector ^ before_.vector) & ~flags) != 0 || now.x87 != before_.x87) write(before_);
  }

  Control before_;
#else
  static void read(std::fenv_t& state) {
    std::fegetenv(&state);
  }
  void restore() {
    std::fesetenv(&before_);
  }

  std::fenv_t before_;
#endif
};

/// Scope guard that sets the initial floating-point state, for our code that foreign code calls in any state.
class UsualFloatingPoint {
 public:
  UsualFloatingPoint() { FloatingPointState::set_usual(); }

 private:
  FloatingPointState of_caller_{};
};

}  // namespace stepwire
