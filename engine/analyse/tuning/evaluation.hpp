#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune_runs.hpp"

namespace stepwire::tuning {

/// What the runs with some values of the parameters gave.
struct Evaluation {
  Values values;                                                ///< of the parameters, SI
  double objective = std::numeric_limits<double>::quiet_NaN();  ///< over all runs
  std::vector<double> offs{};     ///< of the targets: what each is off, in its deviations
  std::vector<double> claims{};   ///< the value of each claim; nan where there is none
  std::vector<double> margins{};  ///< how far each is on the right side: negative where it fails
  std::string fault{};            ///< why there is no objective; empty where there is one
  std::size_t worst = 0;          ///< the run whose objective is the largest
  std::size_t start = 0;          ///< of which search, from 0

  bool is_bad() const { return !fault.empty(); }
  bool is_feasible() const;
};

/// Makes the runs with these values, and all numbers of them. The same bits at any number of threads.
Evaluation evaluate(const TuneRuns& runs, const TuneRequest& request, Values values, unsigned threads);

}  // namespace stepwire::tuning
