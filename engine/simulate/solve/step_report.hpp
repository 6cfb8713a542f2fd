#pragma once

#include <cmath>
#include <cstddef>

namespace stepwire::solve {

/// Fault of a step that its method has detected, as numbers of the workspace.
struct StepReport {
  static constexpr double fine = 0.0, inaccurate = 1.0, unsolved = 2.0, too_many_steps = 3.0, unstable = 4.0;
  static constexpr std::size_t count = 3;
  static constexpr std::size_t longest_step = 3;  ///< longest stable step [s], for an unstable fixed step

  double* numbers = nullptr;  ///< kind, size and state of the fault; nullptr disables the checks
  double tolerance = 2.0;     ///< largest error of a step, relative to the state

  explicit operator bool() const { return numbers != nullptr; }
  void write(double what, double size, std::ptrdiff_t state) const {
    numbers[0] = what;
    numbers[1] = size;
    numbers[2] = static_cast<double>(state);
  }
};

/// Largest of several errors relative to the sizes of their states, and the state that has it.
struct WorstError {
  static constexpr double smallest_size = 1e-9;  ///< of a state, in its SI unit
  double size = 0.0;
  std::ptrdiff_t state = 0;

  void add(double error, double size_of_state, std::ptrdiff_t of) {
    const double relative = std::abs(error) / (size_of_state > smallest_size ? size_of_state : smallest_size);
    if (!(relative > size)) return;
    size = relative;
    state = of;
  }
};

}  // namespace stepwire::solve
