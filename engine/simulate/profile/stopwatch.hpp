#pragma once

#include <algorithm>
#include <functional>
#include <limits>

namespace stepwire::profile {

/// Reads a monotonic clock [s].
using ClockReader = std::function<double()>;

/// Measures actions that may be shorter than a reading of the clock. The shortest of several tries is used,
/// since other load only lengthens a time.
class Stopwatch {
 public:
  explicit Stopwatch(ClockReader read) : read_(std::move(read)) {
    const auto nothing = [] {};
    cost_ = shortest(
        64, [] {}, nothing);
  }

  /// Returns the time that reading the clock adds [s].
  double cost() const { return cost_; }

  /// Returns the time of an action [s], the shortest of `tries`. `prepare` is called before each try and is
  /// not timed.
  template <class Prepare, class Action>
  double shortest(int tries, const Prepare& prepare, const Action& action) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
      prepare();
      const double start = read_();
      action();
      least = std::min(least, read_() - start);
    }
    return std::max(0.0, least - cost_);
  }

  /// Returns the time of an action that may be repeated [s]: the mean of as many repetitions as take `aim`
  /// seconds.
  template <class Action>
  double repeated(double aim, const Action& action) const {
    const auto nothing = [] {};
    const double single = shortest(1, nothing, action);
    const int count = static_cast<int>(std::clamp(aim / std::max(single, 1e-9), 1.0, max_repeats));
    const double together = shortest(2, nothing, [&] {
      for (int i = 0; i < count; ++i) action();
    });
    return count == 1 ? std::min(single, together) : together / count;
  }

 private:
  static constexpr double max_repeats = 100.0;

  ClockReader read_;
  double cost_ = 0.0;  ///< [s]
};

}  // namespace stepwire::profile
