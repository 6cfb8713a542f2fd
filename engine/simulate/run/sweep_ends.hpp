#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Returns " (in the run with speed=3)".
std::string which_run(const std::vector<diagram::Setting>& settings);

/// Collects the ends of the runs of a sweep, in the order of the sweep.
class SweepEnds {
 public:
  /// The job must outlive it.
  explicit SweepEnds(const Job& job) : job_(job) {}

  /// Thread-safe.
  void add(std::size_t point, RunEnd end);
  RunEnd take();

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< point, and index of its diagnostic

  const Job& job_;
  std::mutex mutex_;
  RunEnd all_;
  std::map<std::size_t, RunFault> faults_;
  std::map<std::pair<std::string, std::string>, std::pair<Place, RaisedDiagnostic>> diagnostics_;
};

}  // namespace stepwire::run
