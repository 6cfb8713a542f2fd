#pragma once

#include <cstdint>

#include "engine/simulate/run/call_table.hpp"

namespace stepwire::run {

/// Discrete phase of an instant. It computes the outputs in the order of the wires, with guards, triggers and
/// resets, and then the updates of the active blocks.
class DiscretePhase {
 public:
  DiscretePhase(BoundBlocks& blocks, Participants& who);

  /// Computes the outputs of a tick. With `ahead`, the outputs that depend on states and time alone are
  /// already computed.
  void find_outputs(std::int64_t tick, bool ahead);
  void update() { updates_.run_due(); }
  /// True if the plan has outputs that can be computed ahead.
  bool goes_ahead() const { return !rest_.empty(); }

  /// Begins an event: computes the outputs that guards read and keeps their values. An iteration of the event
  /// is then find_event_outputs() and update_at_event().
  void begin_event();
  void find_event_outputs() { event_outputs_.run(); }
  void update_at_event();

 private:
  void keep();

  Participants& who_;
  CallTable outputs_, rest_, updates_, event_befores_, event_outputs_, event_updates_;
};

}  // namespace stepwire::run
