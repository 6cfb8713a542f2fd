#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/simulate/run/both_sides.hpp"
#include "engine/simulate/run/crossing_looks.hpp"
#include "engine/simulate/run/discrete_phase.hpp"
#include "engine/simulate/run/event_count.hpp"
#include "engine/simulate/run/stepper.hpp"
#include "engine/simulate/solve/event_locator.hpp"

namespace stepwire::run {

/// Goes from one tick to the next, and stops between them at edges of sources and where a crossing changes
/// its sign. First the step is taken whole. With an edge inside, or where a sign has changed or may have
/// changed twice, it is taken again from event to event.
class EventStepper {
 public:
  /// `sides`: is shown what happens; may be null.
  EventStepper(BoundBlocks& blocks, Participants& who, Stepper& stepper, DiscretePhase& phase,
               BothSides* sides);

  void step(std::int64_t tick);
  /// True once `stop_when` has ended the run at an event.
  bool has_stopped() const;
  /// True where the step before has computed outputs of the tick that follow from states and time.
  bool is_ahead() const;
  void forget_ahead();
  /// Something else has changed values or states.
  void forget_end() { knows_end_ = false; }
  /// True after a step with too many events, or without an end to its rounds.
  bool failed() const;
  EventCount count() const;

 private:
  struct BetweenTicks;

  double& report(std::size_t number) const { return values_[plan_.layout.events + number]; }
  void take_whole(std::int64_t tick);
  void take_watched(std::int64_t tick);
  void look_at_start();
  /// Computes what crossings depend on.
  void follow_crossings();
  bool is_eventful(const solve::TimeStep& step, double edge) const;
  void locate(std::int64_t tick);
  /// With the start of the step in its scratch memory.
  solve::EventTask task();

  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  DiscretePhase& phase_;
  BothSides* const sides_;
  CallTable ahead_, crossing_outputs_, crossing_starts_;
  CrossingLooks looks_;
  /// The numbers of crossings at the start and at the end of a step, and the states at that of the last one.
  std::vector<double> before_, after_, end_states_, scratch_;
  const bool states_change_;  ///< may anything but the solver change states?
  bool knows_end_ = false;    ///< are these those of the last step?
};

}  // namespace stepwire::run
