#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_runs.hpp"

namespace stepwire::tuning {

/// Result of the runs at one point of the search.
struct Evaluation {
  Values values;                                                ///< Parameter values, SI.
  double objective = std::numeric_limits<double>::quiet_NaN();  ///< Objective over all runs.
  std::vector<double> offs{};     ///< Error of each target, in units of its deviation.
  std::vector<double> claims{};   ///< Value of each claim; nan if undefined.
  std::vector<double> margins{};  ///< Margin of each claim: negative if it fails.
  std::string fault{};            ///< Reason why there is no objective; empty if there is one.
  std::size_t worst = 0;          ///< Index of the run with the largest objective.
  std::size_t start = 0;          ///< Index of the search, from 0.

  bool is_bad() const { return !fault.empty(); }
  bool is_feasible() const;
};

/// Makes the runs at these values and evaluates objective, targets and claims. The result has the same bits
/// for any number of threads.
Evaluation evaluate(const TuneRuns& runs, const TuneRequest& request, Values values, unsigned threads);

}  // namespace stepwire::tuning
