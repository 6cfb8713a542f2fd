#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stepwire::solve {

/// What is known of located events in a run: numbers of the workspace, in this order.
struct EventReport {
  static constexpr std::size_t events = 0;   ///< all together
  static constexpr std::size_t most = 1;     ///< in one step
  static constexpr std::size_t end = 2;      ///< 1 once there were too many in a step
  static constexpr std::size_t number = 3;   ///< which crossing was the last one then
  static constexpr std::size_t ahead = 4;    ///< 1 where outputs of the next tick are computed
  static constexpr std::size_t stopped = 5;  ///< 1 once the run has ended at one
  static constexpr std::size_t count = 6;
};

inline int sign_of(double number) {
  return (number > 0.0) - (number < 0.0);
}

/// Has a number another sign? 0 is a sign of its own. Every step waits for it: no branch for each number.
inline bool sign_changes(const double* before, const double* after, std::size_t count) {
  bool changes = false;
  for (std::size_t i = 0; i < count; ++i)
    changes |= ((before[i] > 0.0) != (after[i] > 0.0)) | ((before[i] < 0.0) != (after[i] < 0.0));
  return changes;
}

/// A step that is split at events. Offsets are places in the workspace. The scratch memory begins with the
/// states at the start of the step; the crossings there, and at its end, lie at `before` and `after`.
struct EventTask {
  std::size_t time, states, derivatives, state_count;
  std::size_t crossing_count;
  std::size_t report;         ///< where an EventReport lies
  std::int64_t max_per_step;  ///< beyond, the step is given up
  double* scratch;            ///< scratch_size() numbers

  /// Outputs and updates at an event: what is reset may end its own cause.
  static constexpr int rounds = 2;
  static constexpr std::size_t scratch_size(std::size_t states, std::size_t crossings) {
    return 2 * states + 4 * crossings;
  }
  static constexpr std::size_t before(std::size_t states) { return 2 * states; }
  static constexpr std::size_t after(std::size_t states, std::size_t crossings) {
    return 2 * states + crossings;
  }
};

/// Goes again over a step in which something has crossed, from crossing to crossing. A crossing is an instant
/// at which a number changes its sign, where 0 is a sign of its own; it is closed in between two times, each
/// the end of a step of the solver from the last event on, by the secant method of Dowell and Jarratt 1971
/// (Illinois, BIT 11) with halvings, to 1e-12 of the step or the last bit. The step goes on from the later
/// one.
///
/// step(from, to, length) takes the states of the workspace, whose slopes are there, to another time;
/// follow() computes what crossings depend on at its time and states, and look(numbers) the crossings; act()
/// computes all outputs that follow at every instant, updates what does, computes the slopes and what
/// follow() does, and says whether the run ends there; begin() computes what stages do, the slopes and what
/// follow() does.
template <class Step, class Begin, class Follow, class Look, class Act>
class EventLocator {
 public:
  EventLocator(const EventTask& task, double* values, const Step& step, const Begin& begin,
               const Follow& follow, const Look& look, const Act& act)
      : task_(task),
        values_(values),
        step_(step),
        begin_(begin),
        follow_(follow),
        look_(look),
        act_(act),
        x_(task.scratch),
        slopes_(x_ + task.state_count),
        start_(task.scratch + EventTask::before(task.state_count)),
        high_(task.scratch + EventTask::after(task.state_count, task.crossing_count)),
        low_(high_ + task.crossing_count),
        trial_(low_ + task.crossing_count) {}

  /// Goes from `start` on to `end`, `length` behind it.
  void advance(double start, double end, double length) {
    double from = start, left = length;
    std::int64_t events = 0;
    begin_again(start);
    keep();
    for (bool at_end = false; true; at_end = true) {
      const double at = locate(from, end, 1e-12 * length, at_end);
      if (at == end) break;
      if (events++ == task_.max_per_step) {
        give_up();
        break;
      }
      values_[task_.time] = at;
      if (act_()) {
        values_[task_.report + EventReport::stopped] = 1.0;
        break;
      }
      look_(start_);
      from = at;
      left = end - at;
      keep();
      go(from, end, left, high_);
      if (!sign_changes(start_, high_, task_.crossing_count)) break;
    }
    report(static_cast<double>(events));
  }

 private:
  void report(double events) {
    double* report = values_ + task_.report;
    report[EventReport::events] += events;
    report[EventReport::most] = std::max(report[EventReport::most], events);
  }
  void begin_again(double start) {
    std::copy_n(x_, task_.state_count, values_ + task_.states);
    values_[task_.time] = start;
    begin_();
  }

  void keep() {
    std::copy_n(values_ + task_.states, task_.state_count, x_);
    std::copy_n(values_ + task_.derivatives, task_.state_count, slopes_);
  }

  /// Takes the states from those kept, and says what crosses there.
  void go(double from, double to, double length, double* numbers) {
    step_(from, to, length);
    values_[task_.time] = to;
    follow_();
    look_(numbers);
  }
  void go_back() {
    std::copy_n(x_, task_.state_count, values_ + task_.states);
    std::copy_n(slopes_, task_.state_count, values_ + task_.derivatives);
  }

  /// The first time found behind a crossing, with the states there. `at_high`: are they those of the end?
  double locate(double from, double end, double width, bool at_high) {
    double low = from, high = end, low_scale = 1.0, high_scale = 1.0;
    std::copy_n(start_, task_.crossing_count, low_);
    for (int k = 0; high - low > width && std::nextafter(low, high) < high; ++k) {
      const double at =
          k % 4 == 3 ? low + 0.5 * (high - low) : guess(low, high, low_scale, high_scale, width, k == 0);
      go_back();
      go(from, at, at - from, trial_);
      at_high = sign_changes(start_, trial_, task_.crossing_count);
      (at_high ? high : low) = at;
      std::copy_n(trial_, task_.crossing_count, at_high ? high_ : low_);
      // The end that stays counts for half, so that the next guess lies on its side.
      low_scale = at_high ? 0.5 * low_scale : 1.0;
      high_scale = at_high ? 1.0 : 0.5 * high_scale;
    }
    if (!at_high) {
      go_back();
      go(from, high, high - from, trial_);
    }
    return high;
  }

  /// Where the first of the secants meets zero, but no nearer to an end than half the width or the last bit.
  /// What leaves 0 mostly does so at once.
  double guess(double low, double high, double low_scale, double high_scale, double width,
               bool at_once) const {
    double first = 1.0;
    for (std::size_t i = 0; i < task_.crossing_count; ++i) {
      if (sign_of(high_[i]) == sign_of(start_[i])) continue;
      const double from = low_scale * low_[i], to = high_scale * high_[i];
      const double part = from == 0.0 && at_once                     ? 0.0
                          : from == 0.0 || !std::isfinite(to - from) ? 0.5
                                                                     : from / (from - to);
      first = std::min(first, part);
    }
    const double margin = std::min(0.5 * width, 0.25 * (high - low));
    const double at = std::clamp(low + first * (high - low), low + margin, high - margin);
    return std::clamp(at, std::nextafter(low, high), std::nextafter(high, low));
  }

  void give_up() {
    values_[task_.report + EventReport::end] = 1.0;
    for (std::size_t i = task_.crossing_count; i-- > 0;)
      if (sign_of(high_[i]) != sign_of(start_[i]))
        values_[task_.report + EventReport::number] = static_cast<double>(i);
  }

  const EventTask& task_;
  double* values_;
  const Step& step_;
  const Begin& begin_;
  const Follow& follow_;
  const Look& look_;
  const Act& act_;
  double *x_, *slopes_;                    ///< behind the last event
  double *start_, *high_, *low_, *trial_;  ///< crossings there, on both sides of a crossing, and between
};

}  // namespace stepwire::solve
