#pragma once

#include <functional>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Applies the actions that a plan lists for its guards to the numbers of a run.
class Guards {
 public:
  /// `start` calls start() of a block, by its index. The plan and the numbers must outlive this.
  Guards(const plan::Plan& plan, double* values, std::function<void(std::size_t)> start)
      : guards_(plan.guards), values_(values), start_(std::move(start)) {}

  bool active(std::size_t guard) const { return values_[guards_[guard].active] != 0.0; }
  /// Applies the change of a guard after its call; `was` is its previous activity.
  void changed(std::size_t guard, bool was);
  /// Stores the numbers that the solver's stages overwrite. Call it before the step.
  void keep();

 private:
  void switch_off(const plan::PlannedGuard& guard);
  void reset(const plan::PlannedGuard& guard);

  const std::vector<plan::PlannedGuard>& guards_;
  double* values_;
  std::function<void(std::size_t)> start_;
};

}  // namespace stepwire::run
