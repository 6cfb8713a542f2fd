#pragma once

#include <vector>

#include "engine/simulate/run/call_table.hpp"
#include "engine/simulate/run/stepper.hpp"

namespace stepwire::run {

/// Is shown all signals just before an instant, and just after an event. Those after a tick are the ones that
/// evaluate() leaves.
class SideObserver {
 public:
  virtual void before_instant(const double* values) = 0;
  virtual void after_event(const double* values) = 0;

 protected:
  ~SideObserver() = default;
};

/// Computes signals just before an instant, where both of its sides are recorded. It leaves the run as it
/// was: the same bits as without.
class BothSides {
 public:
  BothSides(BoundBlocks& blocks, Participants& who, Stepper& stepper);

  SideObserver* observer = nullptr;

  /// Computes what the solver sees change, with the states and the discrete signals of the moment, and shows
  /// it.
  void before(double time);
  void after_event() const {
    if (observer) observer->after_event(values_);
  }

 private:
  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  CallTable outputs_;
  std::vector<double> kept_;  ///< the whole workspace
};

}  // namespace stepwire::run
