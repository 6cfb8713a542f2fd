#include "engine/simulate/run/left_side.hpp"

#include "engine/simulate/run/whole_step.hpp"

namespace stepwire::run {

LeftSide::LeftSide(BoundBlocks& blocks, Participants& who, Stepper& stepper)
    : plan_(blocks.plan()),
      values_(blocks.values()),
      stepper_(stepper),
      outputs_(plan_.lefts, blocks, who),
      updates_(plan_.left_updates, blocks, who) {}

void LeftSide::update(double time) {
  if (updates_.empty()) return;
  values_[plan::Layout::time] = left_limit(plan_, time, plan_.diagram.step);
  stepper_.follow_time();
  outputs_.run();
  updates_.run();
  values_[plan::Layout::time] = time;
}

}  // namespace stepwire::run
