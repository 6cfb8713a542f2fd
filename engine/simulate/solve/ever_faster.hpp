#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace stepwire::solve {

/// Detects events of one crossing whose intervals shrink towards zero (Zeno behaviour), such as those of a
/// bouncing ball. It stores the last time, the last interval and the number of successive reductions for each
/// crossing and direction.
class EverFaster {
 public:
  EverFaster(double* numbers, std::size_t crossings)
      : last_(numbers), gap_(last_ + 2 * crossings), times_(gap_ + 2 * crossings) {}

  void begin(std::size_t crossings) {
    std::fill_n(last_, 2 * crossings, -std::numeric_limits<double>::infinity());
    std::fill_n(gap_, 2 * crossings, std::numeric_limits<double>::infinity());
    std::fill_n(times_, 2 * crossings, 0.0);
  }

  /// Adds an event of a crossing. Returns true if it is part of a sequence of events that converges in time.
  bool add(std::size_t crossing, bool rises, double at, double step) {
    const std::size_t i = 2 * crossing + (rises ? 1 : 0);
    const double gap = at - last_[i];
    times_[i] = gap < gap_[i] ? times_[i] + 1.0 : 0.0;
    last_[i] = at;
    gap_[i] = gap;
    const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * at;
    return times_[i] > 4.0 && gap < std::max(1e-6 * step, rounding);
  }

 private:
  double *last_, *gap_, *times_;
};

}  // namespace stepwire::solve
