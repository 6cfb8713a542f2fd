#pragma once

#include <functional>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/loop_outcome.hpp"
#include "engine/app/session/monitor.hpp"

namespace stepwire::session {

/// What a call asks of a real-time loop.
struct LoopCall {
  std::string file;
  LoadOptions load;
  LoopWords words;
  std::string out;  ///< folder; empty: nothing is recorded
  bool baseline = false;
  run::ExecutionMode engine = run::ExecutionMode::interpreted;
};

/// Runs a file in real time with its own values; judges no claims. Its rows, loop.json and loop.svg are
/// written to the folder, if there is one. `report` gets the outcome, which ends with the call. Throws Error,
/// EnvironmentError.
void run_loop(const LoopCall& call, const Registry& registry, const Monitor& monitor,
              const std::function<void(const LoopOutcome&)>& report);

}  // namespace stepwire::session
