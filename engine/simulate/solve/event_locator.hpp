#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stepwire::solve {

/// What is known of located events in a run: numbers of the workspace, in this order.
struct EventReport {
  static constexpr std::size_t events = 0;  ///< all together
  static constexpr std::size_t most = 1;    ///< in one step
  static constexpr std::size_t end = 2;     ///< 1 once there were too many in a step
  static constexpr std::size_t number = 3;  ///< which crossing was the last one then
  static constexpr std::size_t count = 4;
};

/// A step that is split at events. Offsets are places in the workspace.
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
};

/// Goes over a step from crossing to crossing. A crossing is an instant at which a number changes its sign,
/// where 0 is a sign of its own; it is closed in between two times, each the end of a step of the solver from
/// the last event on, by the secant method of Dowell and Jarratt 1971 (Illinois, BIT 11) with halvings, to
/// 1e-12 of the step or the last bit. The step goes on from the later one.
///
/// step(from, to, length) takes the states of the workspace, whose slopes are there, to another time;
/// follow() computes what crossings depend on at its time and states, and look(numbers) the crossings; act()
/// computes all outputs that follow at every instant, updates what does, and computes the slopes and what
/// follow() does.
template <class Step, class Follow, class Look, class Act>
class EventLocator {
 public:
  EventLocator(const EventTask& task, double* values, const Step& step, const Follow& follow,
               const Look& look, const Act& act)
      : task_(task), values_(values), step_(step), follow_(follow), look_(look), act_(act) {
    x_ = task.scratch;
    slopes_ = x_ + task.state_count;
    start_ = slopes_ + task.state_count;
    low_ = start_ + task.crossing_count;
    high_ = low_ + task.crossing_count;
    trial_ = high_ + task.crossing_count;
  }

  /// Goes on to `end`, `length` behind `start`, where the slopes are there, and what crossings depend on.
  void advance(double start, double end, double length) {
    double from = start, left = length;
    std::int64_t events = 0;
    look_(start_);
    while (true) {
      keep();
      go(from, end, left, high_);
      if (!crosses(high_)) break;
      const double at = locate(from, end, 1e-12 * length);
      if (at == end) break;
      if (events++ == task_.max_per_step) {
        give_up();
        break;
      }
      values_[task_.time] = at;
      act_();
      look_(start_);
      from = at;
      left = end - at;
    }
    values_[task_.report + EventReport::events] += static_cast<double>(events);
    double& most = values_[task_.report + EventReport::most];
    most = std::max(most, static_cast<double>(events));
  }

 private:
  static int sign(double number) { return (number > 0.0) - (number < 0.0); }

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

  bool crosses(const double* numbers) const {
    for (std::size_t i = 0; i < task_.crossing_count; ++i)
      if (sign(numbers[i]) != sign(start_[i])) return true;
    return false;
  }

  /// The first time found behind a crossing, with the states there.
  double locate(double from, double end, double width) {
    double low = from, high = end, low_scale = 1.0, high_scale = 1.0;
    std::copy_n(start_, task_.crossing_count, low_);
    bool at_high = true;
    for (int k = 0; high - low > width && std::nextafter(low, high) < high; ++k) {
      const double at =
          k % 4 == 3 ? low + 0.5 * (high - low) : guess(low, high, low_scale, high_scale, width);
      go_back();
      go(from, at, at - from, trial_);
      at_high = crosses(trial_);
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
  double guess(double low, double high, double low_scale, double high_scale, double width) const {
    double first = 1.0;
    for (std::size_t i = 0; i < task_.crossing_count; ++i) {
      if (sign(high_[i]) == sign(start_[i])) continue;
      const double from = low_scale * low_[i], to = high_scale * high_[i];
      const double part = from == 0.0 || !std::isfinite(to - from) ? 0.5 : from / (from - to);
      first = std::min(first, part);
    }
    const double margin = std::min(0.5 * width, 0.25 * (high - low));
    const double at = std::clamp(low + first * (high - low), low + margin, high - margin);
    return std::clamp(at, std::nextafter(low, high), std::nextafter(high, low));
  }

  void give_up() {
    values_[task_.report + EventReport::end] = 1.0;
    for (std::size_t i = task_.crossing_count; i-- > 0;)
      if (sign(high_[i]) != sign(start_[i]))
        values_[task_.report + EventReport::number] = static_cast<double>(i);
  }

  const EventTask& task_;
  double* values_;
  const Step& step_;
  const Follow& follow_;
  const Look& look_;
  const Act& act_;
  double *x_, *slopes_;                    ///< behind the last event
  double *start_, *low_, *high_, *trial_;  ///< crossings there, on both sides of a crossing, and between
};

}  // namespace stepwire::solve
