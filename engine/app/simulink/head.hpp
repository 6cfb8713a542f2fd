#pragma once

#include <string>
#include <vector>

#include "engine/app/simulink/block_writer.hpp"

namespace stepwire::simulink {

/// Times of a run, and its solver.
struct Head {
  double step = 0.01, stop = 10.0;  ///< [s]
  bool is_fixed = false;            ///< the step is that of the model
  yaml::Node solver{};              ///< empty: none
  bool locates_events = false;
  bool solves_loops = true;  ///< algebraic loops are solved in the model
};

/// Reads the times and the solver of a configuration. `notes` gets what differs.
Head read_head(FlatModel& model, std::vector<Note>& notes);
/// Fits the step to the sample times, and the stop to the step.
void fit_step(Head& head, const Collected& collected, std::vector<Note>& notes);

}  // namespace stepwire::simulink
