#include "engine/simulate/run/both_sides.hpp"

#include <algorithm>

#include "engine/simulate/run/whole_step.hpp"

namespace stepwire::run {

BothSides::BothSides(BoundBlocks& blocks, Participants& who, Stepper& stepper)
    : plan_(blocks.plan()),
      values_(blocks.values()),
      stepper_(stepper),
      outputs_(plan_.sides, blocks, who),
      kept_(plan_.layout.size) {}

void BothSides::before(double time, double instant) {
  if (!observer) return;
  std::copy_n(values_, kept_.size(), kept_.begin());
  values_[plan::Layout::time] = left_limit(plan_, time, plan_.diagram.step);
  stepper_.follow_time();
  outputs_.run();
  values_[plan::Layout::time] = instant;
  observer->before_instant(values_);
  std::ranges::copy(kept_, values_);
}

}  // namespace stepwire::run
