#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <stepwire/model.hpp>
#include <stepwire/observer.hpp>

#include "engine/simulate/record/recording.hpp"
#include "engine/simulate/run/execution_mode.hpp"
#include "engine/simulate/run/run_fault.hpp"

namespace stepwire {

using record::Recording;
using run::ExecutionMode;
using run::RaisedDiagnostic;
using run::RunFault;

struct SimulateOptions {
  std::vector<Observer*> observers{};  ///< observers of every run; must outlive the call
  std::stop_token stop{};  ///< ends the runs early; their recordings are kept
  ExecutionMode engine = ExecutionMode::automatic;
  unsigned threads = 0;  ///< for sweeps; 0: all cores
  std::function<void(double)> progress{};  ///< callback with the done fraction, from any thread
};

/// Recordings and ends of a run, or of all runs of a sweep.
struct Result {
  /// One for each period at which the file records. For a sweep that keeps numbers of each run, one with
  /// these numbers.
  std::vector<Recording> recordings;
  std::vector<RunFault> faults;  ///< at most one for each run
  std::vector<RaisedDiagnostic> diagnostics;
  bool interrupted = false;  ///< by SimulateOptions::stop
  std::int64_t ticks = 0;  ///< of all runs together
  std::int64_t compiled_ticks = 0;  ///< ticks of them that compiled code made
  std::string compile_problem;  ///< reason why chosen compiled code is missing; else empty

  /// Returns a column by its name, "time" or that of `record` ("path.2" of a vector), from the first
  /// recording that has it. The runs of a sweep are concatenated, with their starts in Recording::starts.
  /// Throws Error with the nearest name for an unknown one.
  std::span<const double> operator[](const std::string& column) const;
};

/// Runs a model to its end, with all points of its sweep. Faults of runs are in the result.
Result simulate(const Model& model, const SimulateOptions& options = {});

}  // namespace stepwire
