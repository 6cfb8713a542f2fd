#pragma once

#include "engine/simulate/run/call_table.hpp"
#include "engine/simulate/run/stepper.hpp"

namespace stepwire::run {

/// Updates of blocks that read their inputs just before each instant.
class LeftSide {
 public:
  LeftSide(BoundBlocks& blocks, Participants& who, Stepper& stepper);

  /// Updates these blocks with the limit at `time` from the left. The states and the discrete signals must be
  /// those before the instant. The time of the workspace is `time` afterwards.
  void update(double time);

 private:
  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  CallTable outputs_, updates_;
};

}  // namespace stepwire::run
