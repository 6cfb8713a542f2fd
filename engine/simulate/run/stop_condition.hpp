#pragma once

#include <optional>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Evaluates `stop_when` at a tick.
class StopConditionEvaluator {
 public:
  explicit StopConditionEvaluator(const plan::Plan& plan) {
    if (!plan.diagram.stop_when) return;
    condition_ = plan.diagram.stop_when->expression;
    for (const diagram::SignalRef& variable : plan.diagram.stop_when->variables)
      offsets_.push_back(plan.offset(variable));
  }
  bool stops(const double* values) const { return condition_ && (*condition_)(values, offsets_) != 0.0; }

 private:
  std::optional<expression::Expression> condition_;
  std::vector<std::size_t> offsets_;
};

}  // namespace stepwire::run
