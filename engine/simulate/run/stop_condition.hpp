#pragma once

#include <optional>
#include <vector>

#include "engine/base/expression/margin.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Returns the workspace places of the signals that `stop_when` reads.
inline std::vector<std::size_t> stop_offsets(const plan::Plan& plan) {
  std::vector<std::size_t> offsets;
  for (const diagram::SignalRef& variable : plan.diagram.stop_when->variables)
    offsets.push_back(plan.offset(variable));
  return offsets;
}

/// Evaluates `stop_when` at a tick.
class StopConditionEvaluator {
 public:
  explicit StopConditionEvaluator(const plan::Plan& plan) {
    if (!plan.diagram.stop_when) return;
    condition_ = plan.diagram.stop_when->expression;
    uses_libm_ = plan.diagram.uses_libm;
    offsets_ = stop_offsets(plan);
  }
  bool stops(const double* values) const {
    if (!condition_) return false;
    const fn::Selection selection(uses_libm_);
    return (*condition_)(values, offsets_) != 0.0;
  }

 private:
  std::optional<expression::Expression> condition_;
  bool uses_libm_ = false;
  std::vector<std::size_t> offsets_;
};

/// Number that changes its sign where `stop_when` becomes true. The plan must have a `stop_when`.
class StopMargin {
 public:
  explicit StopMargin(const plan::Plan& plan)
      : stops_(plan), margin_(expression::margin_of(plan.diagram.stop_when->expression)) {
    offsets_ = stop_offsets(plan);
  }
  double operator()(const double* values) const { return margin_(values, offsets_); }
  bool stops(const double* values) const { return stops_.stops(values); }

 private:
  StopConditionEvaluator stops_;
  expression::Expression margin_;
  std::vector<std::size_t> offsets_;
};

}  // namespace stepwire::run
