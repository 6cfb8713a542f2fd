#pragma once

#include <functional>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Carries out what a plan lists for its guards, on the numbers of a run.
class Guards {
 public:
  /// `start` calls start() of a block, by its index. The plan and the numbers must outlive this.
  Guards(const plan::Plan& plan, double* values, std::function<void(std::size_t)> start)
      : guards_(plan.guards), values_(values), start_(std::move(start)) {}

  bool active(std::size_t guard) const { return values_[guards_[guard].active] != 0.0; }
  /// A guard has been run; `was` is what it was before.
  void changed(std::size_t guard, bool was);
  /// Before the solver's step: keeps what its stages overwrite.
  void keep();

 private:
  void switch_off(const plan::PlannedGuard& guard);
  void reset(const plan::PlannedGuard& guard);

  const std::vector<plan::PlannedGuard>& guards_;
  double* values_;
  std::function<void(std::size_t)> start_;
};

}  // namespace stepwire::run
