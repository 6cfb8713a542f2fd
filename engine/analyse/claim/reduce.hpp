#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

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

/// The number that a reduction makes of all selected rows of all runs; at least one row is selected.
/// Not for `final` and `at`, and those of steps only for the rows of one run.
double reduce(Reduction reduction, const Rows& rows);

}  // namespace stepwire::claim
