#pragma once

#include <vector>

#include "engine/simulate/run/call_table.hpp"
#include "engine/simulate/run/stepper.hpp"

namespace stepwire::run {

/// Observer of all signals just before an instant and just after an event. The values just after a tick are
/// those that evaluate() leaves.
class SideObserver {
 public:
  virtual void before_instant(const double* values) = 0;
  virtual void after_event(const double* values) = 0;

 protected:
  ~SideObserver() = default;
};

/// Computes the signals just before an instant, where both one-sided values are recorded. The workspace is
/// restored afterwards, so the run has the same bits as without it.
class BothSides {
 public:
  BothSides(BoundBlocks& blocks, Participants& who, Stepper& stepper);

  SideObserver* observer = nullptr;

  /// Computes the time-dependent and continuous signals from the present states and discrete signals, as the
  /// limit at `time` from the left. Passes them to the observer as those before an instant.
  void before(double time, double instant);
  void after_event() const {
    if (observer) observer->after_event(values_);
  }

 private:
  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  CallTable outputs_;
  std::vector<double> kept_;  ///< copy of the whole workspace
};

}  // namespace stepwire::run
