#pragma once

#include <cstdint>

#include "engine/simulate/run/call_table.hpp"

namespace stepwire::run {

/// The discrete phase of an instant: outputs in the order of wires, with guards, triggers and resets, then
/// updates of the blocks that take part.
class DiscretePhase {
 public:
  DiscretePhase(BoundBlocks& blocks, Participants& who);

  /// At a tick. `ahead`: what follows from the states and the time alone is computed already.
  void find_outputs(std::int64_t tick, bool ahead);
  void update() { updates_.run_due(); }
  /// True with outputs that can be computed ahead.
  bool goes_ahead() const { return !rest_.empty(); }

  /// At an event: outputs that guards read, and their present values are kept; then one round.
  void begin_event();
  void round();

 private:
  void keep();

  Participants& who_;
  CallTable outputs_, rest_, updates_, event_befores_, event_outputs_, event_updates_;
};

}  // namespace stepwire::run
