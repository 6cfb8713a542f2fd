#pragma once

#include <optional>
#include <vector>

#include "engine/plan/plan.hpp"

namespace stepwire {

/// Evaluates `stop_when` at a tick.
class Stopper {
 public:
  explicit Stopper(const Plan& plan) {
    if (!plan.diagram.stop_when) return;
    condition_ = plan.diagram.stop_when->expression;
    for (const StopCondition::Variable& variable : plan.diagram.stop_when->variables)
      offsets_.push_back(plan.offset(variable));
    numbers_.resize(offsets_.size());
  }
  bool stops(const double* values) {
    if (!condition_) return false;
    for (std::size_t i = 0; i < offsets_.size(); ++i) numbers_[i] = values[offsets_[i]];
    return (*condition_)(numbers_) != 0.0;
  }

 private:
  std::optional<Expression> condition_;
  std::vector<std::size_t> offsets_;
  std::vector<double> numbers_;
};

}  // namespace stepwire
