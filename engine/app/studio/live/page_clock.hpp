#pragma once

#include <array>
#include <limits>

namespace stepwire::live {

/// Estimator of the offset between the clock of a page and the one of this process. Delays are never
/// negative, so the smallest difference of send and arrival time is the best estimate. The minimum covers the
/// last 10 to 20 s, as clocks drift.
class PageClock {
 public:
  /// Adds a message that was sent at `page` and arrived at `now` [s].
  void came(double page, double now) {
    if (now - began_ > window) {
      offsets_[1] = offsets_[0];
      offsets_[0] = std::numeric_limits<double>::infinity();
      began_ = now;
    }
    if (now - page < offsets_[0]) offsets_[0] = now - page;
  }

  /// Converts a time of the page to the clock of this process; infinite before the first message.
  double here(double page) const { return page + (offsets_[0] < offsets_[1] ? offsets_[0] : offsets_[1]); }

 private:
  static constexpr double window = 10.0;  // [s]
  static constexpr double none = std::numeric_limits<double>::infinity();

  double began_ = -none;
  std::array<double, 2> offsets_{none, none};
};

}  // namespace stepwire::live
