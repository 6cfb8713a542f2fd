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
  std::vector<Observer*> observers{};  ///< of every run; must outlive the call
  std::stop_token stop{};              ///< ends the runs, which keep what they have
  ExecutionMode engine = ExecutionMode::automatic;
  unsigned threads = 0;                    ///< for sweeps; 0: all cores
  std::function<void(double)> progress{};  ///< called with the fraction done, now and then, from any thread
};

/// What a run, or all runs of a sweep, recorded, and how they ended.
struct Result {
  /// One for each period at which the file records; of a sweep that keeps numbers of each run one with these.
  std::vector<Recording> recordings;
  std::vector<RunFault> faults;       ///< at most one for each run
  std::vector<RaisedDiagnostic> diagnostics;
  bool interrupted = false;         ///< by SimulateOptions::stop
  std::int64_t ticks = 0;           ///< of all runs together
  std::int64_t compiled_ticks = 0;  ///< of them, those that compiled code made
  std::string compile_problem;      ///< why there was no compiled code although it was chosen; else empty

  /// A column by its name, "time" or as `record` has it ("path.2" of a vector), of the first recording that
  /// has it; the runs of a sweep one behind the other, from Recording::starts on. Throws Error with the
  /// nearest name where there is none.
  std::span<const double> operator[](const std::string& column) const;
};

/// Runs a model to its end, with all points of its sweep. A fault of a run is in the result.
Result simulate(const Model& model, const SimulateOptions& options = {});

}  // namespace stepwire
