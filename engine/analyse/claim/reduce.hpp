#pragma once

#include <cstddef>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/base/math/sum_of_squares.hpp"

namespace stepwire::claim {

/// Rows that a claim reads: values, times, selection, and the first row of each run.
struct Rows {
  std::vector<double> value;
  std::vector<double> other;  ///< Second column of rising and fit.
  std::vector<double> time;
  std::vector<bool> selected;
  std::vector<std::size_t> starts;
  bool free_offset = false;  ///< fit: a constant offset between model and measurement is no error.
  double share = 0.5;        ///< Share of quantile.

  /// Returns the rows of one run.
  Rows of_run(std::size_t run) const;
  std::size_t run_end(std::size_t run) const {
    return run + 1 < starts.size() ? starts[run + 1] : value.size();
  }
};

/// Reduces the selected rows of consecutive runs to one number. It keeps rows only for reductions that need
/// all of them. Not for `final`, `at` and the step reductions.
class Reducing {
 public:
  explicit Reducing(Reduction reduction) : reduction_(reduction) {}

  /// Adds the rows of further runs.
  void add(const Rows& rows);
  /// Returns the reduced number. Requires at least one selected row.
  double value() const;

 private:
  void add_edges(const Rows& rows);
  void add_times(const Rows& rows);
  void take(double value);
  double time_mean() const;
  double rms() const;

  Reduction reduction_;
  bool free_offset_ = false, undefined_ = false;
  double share_ = 0.5;
  double largest_ = 0.0, smallest_ = 0.0;
  double integral_ = 0.0, duration_ = 0.0, sum_ = 0.0;
  SumOfSquares square_integral_, square_sum_;  ///< Sums of rms.
  std::size_t all_ = 0;                        ///< Number of selected rows.
  std::size_t counted_ = 0;                    ///< Number of selected rows that fraction or count counts.
  std::vector<double> values_, others_;        ///< Rows of reductions that sort or need all values.
};

/// True if the reduction needs all rows of all runs at once.
bool keeps_rows(Reduction reduction);

/// Reduces all selected rows of all runs; at least one row must be selected. Not for `final` and `at`. Step
/// reductions accept the rows of one run only.
double reduce(Reduction reduction, const Rows& rows);

/// True for overshoot, rise_time, settling_time, peak_time, iae and steady_error, which are defined for one
/// run.
bool is_of_step(Reduction reduction);

/// Computes such a number from the selected rows of one run; at least one must be selected. Definitions are
/// those of stepinfo in MATLAB. The first selected row is the initial value, the last one the final value.
/// Times count from the first row and are interpolated linearly. Returns nan if the signal ends at its
/// initial value, or if a value is nan.
double reduce_step(Reduction reduction, const Rows& rows);

}  // namespace stepwire::claim
