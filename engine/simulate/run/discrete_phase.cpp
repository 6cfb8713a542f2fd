#include "engine/simulate/run/discrete_phase.hpp"

namespace stepwire::run {

DiscretePhase::DiscretePhase(BoundBlocks& blocks, Participants& who)
    : who_(who),
      outputs_(blocks.plan().outputs, blocks, who),
      rest_(blocks.plan().rest, blocks, who),
      updates_(blocks.plan().updates, blocks, who),
      event_befores_(blocks.plan().event_befores, blocks, who),
      event_outputs_(blocks.plan().event_outputs, blocks, who),
      event_updates_(blocks.plan().event_updates, blocks, who) {}

void DiscretePhase::find_outputs(std::int64_t tick, bool ahead) {
  who_.find_due(tick);
  (ahead ? rest_ : outputs_).run_due();
}

void DiscretePhase::begin_event() {
  event_befores_.run();
  keep();
}

void DiscretePhase::update_at_event() {
  event_updates_.run();
  keep();
}

/// Stores the numbers that a guard restores when it switches off, if an event can switch it off.
void DiscretePhase::keep() {
  if (!event_befores_.empty()) who_.keep();
}

}  // namespace stepwire::run
