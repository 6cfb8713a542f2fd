#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/simulate/solve/crossing_signs.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/left_of.hpp"

namespace stepwire::solve {

/// Integrates from one tick to the next with a solver with error control, and locates events.
///
/// The solver integrates to the next edge of a source, which is known beforehand, and begins anew there. The
/// crossing functions are checked after each of its own steps. Only a step that may contain a crossing is
/// repeated from event to event. Without events the steps are the same as in a run without event location.
///
/// Beside the functions of a `Run` of EventLocator, `Run` has advance_watched(from, to, length, stops). It is
/// advance() with a predicate that is called after each step but the last one and may end the integration.
template <class Run>
class WatchedStep {
 public:
  WatchedStep(const EventTask& task, double* values, const Run& run)
      : task_(task),
        values_(values),
        run_(run),
        before_(task.scratch + EventTask::before(task.state_count)),
        after_(before_ + task.crossing_count) {}

  void advance(double start, double end, double length) {
    double from = start;
    bool pending = false;  // true if something has crossed at the very end of the last interval
    while (from < end) {
      begin(from, pending);
      const bool to_edge = left_of(edge_, length) > from && edge_ < left_of(end, length);
      const double target = to_edge ? edge_ : end;
      double reached = target;
      const Here here(*this, reached);
      run_.advance_watched(from, task_.jumps ? left_of(target, length) : target,
                           from == start && !to_edge ? length : target - from, here);
      if (reached == end && !is_eventful(end, true)) return;
      const Reach reach = reached == end ? Reach::tick : reached == target ? Reach::edge : Reach::inside;
      EventLocator(task_, values_, run_).advance(open_, reached, reached - open_, reach);
      if (has_ended()) return;
      from = reached;
      run_.follow();
      run_.crossings(after_);
      pending = sign_changes(before_, after_, task_.crossing_count);
    }
  }

 private:
  /// Predicate that ends the integration where an event may have happened.
  struct Here : Stops {
    Here(WatchedStep& step, double& reached) : step(step), reached(reached) {}
    bool operator()(double at) const override {
      if (step.ends_at_edge(at) || !step.is_eventful(at)) return false;
      reached = at;
      return true;
    }

    WatchedStep& step;
    double& reached;
  };

  void begin(double at, bool pending) {
    values_[task_.time] = at;
    run_.begin();
    if (!pending) run_.crossings(before_);
    open(at);
  }
  /// Begins a new interval at this time.
  void open(double at) {
    open_ = at;
    edge_ = run_.edge();
    std::copy_n(values_ + task_.states, task_.state_count, task_.scratch);
    task_.loops.keep(values_, task_.scratch + task_.guesses());
  }

  /// True if the next edge is at this time but for rounding. No event is handled at the end of an interval,
  /// so the interval is extended beyond such an edge.
  bool ends_at_edge(double at) const { return edge_ <= at && edge_ >= left_of(at, at - open_); }

  bool is_eventful(double at, bool at_tick = false) {
    const double length = at - open_;
    const bool before = task_.jumps && (at_tick || left_of(edge_, length) <= at);
    values_[task_.time] = before ? left_of(at, length) : at;
    run_.follow();
    run_.crossings(after_);
    const CrossingPast past(values_ + task_.report + EventReport::count, task_.crossing_count);
    const bool edge = edge_ < left_of(at, length);
    if (solve::is_eventful(before_, after_, past,
                           {length, edge, at_tick, task_.looks > 0, task_.looks_always}))
      return true;
    std::copy_n(after_, task_.crossing_count, before_);
    open(at);
    return false;
  }

  bool has_ended() const {
    const double* report = values_ + task_.report;
    return report[EventReport::end] != 0.0 || report[EventReport::stopped] != 0.0 || run_.failed();
  }

  const EventTask& task_;
  double* const values_;
  const Run& run_;
  double *before_, *after_;         ///< crossing functions at the start of the interval and at its end
  double open_ = 0.0, edge_ = 0.0;  ///< start of the interval, and the next edge of a source there
};

}  // namespace stepwire::solve
