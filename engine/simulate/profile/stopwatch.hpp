#pragma once

#include <algorithm>
#include <functional>
#include <limits>

namespace stepwire::profile {

/// Reads a clock that goes on steadily [s].
using ClockReader = std::function<double()>;

/// Times things that may take less than reading the clock does. Of several tries the shortest counts: what
/// else runs on the machine only ever adds to a time.
class Stopwatch {
 public:
  explicit Stopwatch(ClockReader read) : read_(std::move(read)) {
    const auto nothing = [] {};
    cost_ = shortest(
        64, [] {}, nothing);
  }

  /// What reading the clock adds to a time [s].
  double cost() const { return cost_; }

  /// Time of an action [s], the shortest of `tries`; `prepare` goes before each and is not timed.
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

  /// Time of an action that may be repeated [s]: the mean of as many in a row as take `aim` seconds.
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
