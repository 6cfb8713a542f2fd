#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// " (in the run with speed=3)".
std::string which_run(const std::vector<diagram::Setting>& settings);

/// Gathers how the runs of a sweep ended, in their order.
class SweepEnds {
 public:
  /// The job must outlive it.
  explicit SweepEnds(const Job& job) : job_(job) {}

  /// From any thread.
  void add(std::size_t point, RunEnd end);
  RunEnd take();

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< point, and which of its diagnostics

  const Job& job_;
  std::mutex mutex_;
  RunEnd all_;
  std::map<std::size_t, RunFault> faults_;
  std::map<std::pair<std::string, std::string>, std::pair<Place, RaisedDiagnostic>> diagnostics_;
};

}  // namespace stepwire::run
