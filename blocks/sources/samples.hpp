#pragma once

#include <algorithm>
#include <cmath>
#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Rows of numbers over time.
struct Samples {
  Numbers time;           ///< of each row [s], increasing, with two equal ones at a jump
  Matrix value;           ///< a column for each row, so that a row is contiguous in memory
  double interval = 0.0;  ///< mean time between rows of different times [s]

  Index rows() const { return time.size(); }
  double begin() const { return time[0]; }
  double end() const { return time[rows() - 1]; }
  /// True for the second of two rows at one time: the values after a jump.
  bool is_jump(Index row) const { return row > 0 && time[row] == time[row - 1]; }
  bool has_jumps() const {
    for (Index row = 1; row < rows(); ++row)
      if (is_jump(row)) return true;
    return false;
  }
  /// Returns the period of repetition: the first row follows the last after one mean interval.
  double period() const { return end() - begin() + interval; }
  /// Returns the tolerance [s] by which a row is reached early: instants and rows are both rounded, and a
  /// held row must not be late.
  double slack() const { return 1e-6 * interval; }
  /// Returns the same instant within the first period.
  double wrapped(double t) const { return t - period() * std::floor((t - begin()) / period()); }

  /// Returns the last row at or before t, at least the first one. The search takes constant time for nearly
  /// even rows.
  Index row_at(double t) const {
    const double guess = (t - begin()) / interval;
    Index row = guess <= 0.0                               ? 0
                : guess >= static_cast<double>(rows() - 1) ? rows() - 1
                                                           : static_cast<Index>(guess);
    if (holds(row, t)) return row;
    if (row > 0 && holds(row - 1, t)) return row - 1;
    const double* const first = time.data();
    return std::max<Index>(std::upper_bound(first, first + rows(), t) - first - 1, 0);
  }

 private:
  bool holds(Index row, double t) const {
    return (row == 0 || time[row] <= t) && (row == rows() - 1 || t < time[row + 1]);
  }
};

}  // namespace stepwire
