#include "engine/model/plan/run_ends.hpp"

namespace stepwire::plan {

std::vector<std::size_t> places_of_ends(const Plan& plan, bool as_fault) {
  std::vector<std::size_t> places;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const auto& specs = plan.diagram.blocks[b].type().diagnostics;
    for (std::size_t n = 0; n < specs.size(); ++n)
      if (specs[n].ends_run && specs[n].is_fault == as_fault)
        places.push_back(plan.blocks[b].diagnostics[n].offset);
  }
  return places;
}

bool may_end_between(const Plan& plan) {
  return plan.splits_steps() && (plan.stop_crossing || !places_of_ends(plan, true).empty());
}

}  // namespace stepwire::plan
