#include "engine/model/plan/draft_shapes.hpp"

#include <stdexcept>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

DraftShapes draft_shapes(diagram::Diagram diagram) {
  DraftShapes found;
  Plan plan;
  plan.diagram = std::move(diagram);
  plan.blocks.resize(plan.diagram.blocks.size());
  Draft draft(plan);
  try {
    plan_rates(draft);
    configure_blocks(draft);
    if (draft.report.faults().size() > 0) return found;
    plan_shapes(draft);
    found.faults = yaml::Error(draft.report.faults().list()).faults();
    if (found.faults.empty()) found.outputs = output_shapes(draft);
  } catch (const std::exception&) {  // too many faults, or a missing file
    found.faults.clear();
  }
  return found;
}

}  // namespace stepwire::plan
