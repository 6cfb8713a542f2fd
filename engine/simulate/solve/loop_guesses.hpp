#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/simulate/solve/loop_task.hpp"

namespace stepwire::solve {

/// Guesses and residuals of solved loops. A solution depends on its guess within the tolerance of the loop,
/// so a search for events begins with those of the step and restores them where it finds nothing. The bits of
/// a step without events are then those of a run without event location.
struct LoopGuesses {
  const Tear* tears = nullptr;
  std::size_t tear_count = 0;

  bool empty() const { return tear_count == 0; }
  /// Returns the count of numbers to keep.
  std::size_t count() const {
    std::size_t sum = 0;
    for (std::size_t t = 0; t < tear_count; ++t) sum += 2 * tears[t].size;
    return sum;
  }
  void keep(const double* values, double* numbers) const {
    for (std::size_t t = 0; t < tear_count; ++t) {
      numbers = std::copy_n(values + tears[t].offset, tears[t].size, numbers);
      numbers = std::copy_n(values + tears[t].residual, tears[t].size, numbers);
    }
  }
  void restore(const double* numbers, double* values) const {
    for (std::size_t t = 0; t < tear_count; ++t) {
      std::copy_n(numbers, tears[t].size, values + tears[t].offset);
      std::copy_n(numbers + tears[t].size, tears[t].size, values + tears[t].residual);
      numbers += 2 * tears[t].size;
    }
  }
};

}  // namespace stepwire::solve
