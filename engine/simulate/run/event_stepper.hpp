#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/simulate/run/both_sides.hpp"
#include "engine/simulate/run/crossing_looks.hpp"
#include "engine/simulate/run/discrete_phase.hpp"
#include "engine/simulate/run/event_count.hpp"
#include "engine/simulate/run/left_side.hpp"
#include "engine/simulate/run/stepper.hpp"
#include "engine/simulate/solve/event_locator.hpp"

namespace stepwire::run {

/// Steps a run from tick to tick and splits the step at events.
///
/// Events are edges of sources and sign changes of zero-crossing functions. The step is first taken whole,
/// which is the cheap and usual case. If it contains an edge, or a sign has changed or may have changed
/// twice, the step is repeated from event to event.
class EventStepper {
 public:
  /// `sides` receives the values on both sides of each event; it may be nullptr.
  EventStepper(BoundBlocks& blocks, Participants& who, Stepper& stepper, LeftSide& left, DiscretePhase& phase,
               BothSides* sides);

  /// Observer of located events; nullptr: none. Just before an event it reads the signals of the crossing
  /// functions alone.
  SideObserver* observer = nullptr;

  /// Keeps the states before the updates of a tick.
  void keep_states();
  void step(std::int64_t tick);
  /// True once `stop_when` has ended the run at an event.
  bool has_stopped() const;
  /// True if the last step has computed the outputs of the tick that depend on states and time alone.
  bool is_ahead() const;
  void forget_ahead();
  /// Invalidates the stored end of the last step, after a change of values or states from outside.
  void forget_end() { knows_end_ = false; }
  /// True after a step with too many events, or with an event whose iteration does not converge.
  bool failed() const;
  EventCount count() const;

 private:
  struct BetweenTicks;

  double& report(std::size_t number) const { return values_[plan_.layout.events + number]; }
  bool settle_tick();
  void take_whole(std::int64_t tick);
  void take_watched(std::int64_t tick);
  void look_at_start();
  /// Computes the signals that the crossing functions read.
  void follow_crossings();
  bool is_eventful(const solve::TimeStep& step, double edge) const;
  void locate(std::int64_t tick);
  /// Returns the task of the step, with the start of the step in its scratch memory.
  solve::EventTask task();

  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  LeftSide& left_;
  DiscretePhase& phase_;
  BothSides* const sides_;
  CallTable ahead_, crossing_outputs_, crossing_starts_;
  CrossingLooks looks_;
  /// Crossing functions at the start and at the end of a step, and the states at the end of the last step and
  /// before the updates of a tick.
  std::vector<double> before_, after_, end_states_, tick_states_, scratch_;
  const bool states_change_;  ///< true if states change outside of the solver
  bool knows_end_ = false;    ///< true while after_ and end_states_ are those of the last step
};

}  // namespace stepwire::run
