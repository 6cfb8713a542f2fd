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
#include "engine/simulate/solve/crossing_signs.hpp"
#include "engine/simulate/solve/event_task.hpp"

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
  /// Returns the address of a number that is not 0 once `stop_when` has ended the run at an event.
  const double* stopped() const;
  /// True if the last step has computed the outputs of the tick that depend on states and time alone.
  bool is_ahead() const;
  void forget_ahead();
  /// Invalidates the stored end of the last step, after a change of values or states from outside.
  void forget_end() { knows_end_ = false; }
  /// True after a step with too many events, or with an event whose iteration does not converge.
  bool failed() const;
  /// True after a step with an event that has ended the run.
  bool has_ended() const { return failed() || *stopped() != 0.0; }
  EventCount count() const;

 private:
  struct BetweenTicks;

  double& report(std::size_t number) const { return values_[plan_.layout.events + number]; }
  bool settle_tick();
  void take_whole(std::int64_t tick);
  void take_watched(std::int64_t tick);
  /// Finds the crossing functions at the start of a step. Returns true if they are those at the end of the
  /// last one, and that was not eventful.
  bool look_at_start();
  /// Computes the signals that the crossing functions read.
  void follow_crossings();
  bool is_eventful(const solve::TimeStep& step, double edge, bool continues) const;
  /// True if the step needs no closer look: without edges, from a step like it, and with all numbers within
  /// their bands.
  bool is_quiet(const solve::TimeStep& step, double edge, bool continues) const;
  void locate(std::int64_t tick);
  /// Returns the task of the step, with the start of the step in its scratch memory.
  solve::EventTask task();
  solve::EventTask task_in(double* scratch) const;

  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  LeftSide& left_;
  DiscretePhase& phase_;
  BothSides* const sides_;
  CallTable ahead_, crossing_outputs_, crossing_starts_;
  CrossingLooks looks_;
  std::vector<double> crossings_;                 ///< numbers of the crossing functions, twice
  double *before_, *after_;                       ///< those at the start and at the end of a step
  std::vector<double> end_states_, tick_states_;  ///< at the end of the last step, before updates of a tick
  std::vector<solve::Tear> tears_;                ///< of all loops
  const solve::LoopGuesses loops_;
  std::vector<double> guesses_;  ///< of the loops at the start of the step
  std::vector<double> scratch_;  ///< of EventTask
  const solve::CrossingPast past_;
  const bool looks_always_;   ///< True if each step is examined.
  const bool states_change_;  ///< True if states change outside of the solver.
  const bool starts_change_;  ///< True if crossing functions may change between two steps.
  bool knows_end_ = false;    ///< true while after_ and end_states_ are those of the last step
  bool was_eventful_ = true;  ///< true if the last step was
};

}  // namespace stepwire::run
