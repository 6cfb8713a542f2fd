#pragma once

#include <functional>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/loop_outcome.hpp"
#include "engine/app/session/monitor.hpp"

namespace stepwire::session {

/// Options of a real-time loop.
struct LoopCall {
  std::string file;
  LoadOptions load;
  LoopWords words;
  std::string out;  ///< folder; empty: nothing is recorded
  bool baseline = false;
  run::ExecutionMode engine = run::ExecutionMode::interpreted;
};

/// Runs a file in real time with its own values, without judging claims. Writes rows, loop.json and loop.svg
/// into the folder, if there is one.
/// `report` gets the outcome, which is valid during that call. Throws Error and EnvironmentError.
void run_loop(const LoopCall& call, const Registry& registry, const Monitor& monitor,
              const std::function<void(const LoopOutcome&)>& report);

}  // namespace stepwire::session
