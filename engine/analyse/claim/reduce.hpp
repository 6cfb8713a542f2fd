#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/base/math/sum_of_squares.hpp"

namespace stepwire::claim {

/// Rows that a claim looks at: values, time, which rows are selected, and where the runs lie.
struct Rows {
  std::vector<double> value;
  std::vector<double> other;  ///< second column of rising and fit
  std::vector<double> time;
  std::vector<bool> selected;
  std::vector<std::size_t> starts;
  bool free_offset = false;  ///< fit: the mean difference is no error
  double share = 0.5;        ///< quantile

  /// One run by itself.
  Rows of_run(std::size_t run) const;
  std::size_t run_end(std::size_t run) const {
    return run + 1 < starts.size() ? starts[run + 1] : value.size();
  }
};

/// Makes the number of a reduction of all selected rows of runs that come one after the other, without
/// keeping them where it can. Not for `final` and `at`, and those of steps.
class Reducing {
 public:
  explicit Reducing(Reduction reduction) : reduction_(reduction) {}

  /// Adds the rows of further runs.
  void add(const Rows& rows);
  /// At least one row was selected.
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
  SumOfSquares square_integral_, square_sum_;  ///< of rms
  std::size_t all_ = 0;                        ///< selected rows
  std::size_t counted_ = 0;                    ///< of them, those that a fraction or a count counts
  std::vector<double> values_, others_;        ///< of reductions that have to sort or to see all
};

/// Has the reduction to see all rows of all runs at once?
bool keeps_rows(Reduction reduction);

/// The number that a reduction makes of all selected rows of all runs; at least one row is selected.
/// Not for `final` and `at`, and those of steps only for the rows of one run.
double reduce(Reduction reduction, const Rows& rows);

}  // namespace stepwire::claim
