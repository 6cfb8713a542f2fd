#pragma once

#include <array>
#include <limits>

namespace stepwire::live {

/// What the clock of a page shows against that of this process. A message takes at least no time, so that the
/// one which took the least tells most; of the last ten to twenty seconds, since clocks drift.
class PageClock {
 public:
  /// A message that the page sent at `page` came at `now` [s].
  void came(double page, double now) {
    if (now - began_ > window) {
      offsets_[1] = offsets_[0];
      offsets_[0] = std::numeric_limits<double>::infinity();
      began_ = now;
    }
    if (now - page < offsets_[0]) offsets_[0] = now - page;
  }

  /// When it was at this process what the page's clock showed; not before the first message.
  double here(double page) const { return page + (offsets_[0] < offsets_[1] ? offsets_[0] : offsets_[1]); }

 private:
  static constexpr double window = 10.0;  // [s]
  static constexpr double none = std::numeric_limits<double>::infinity();

  double began_ = -none;
  std::array<double, 2> offsets_{none, none};
};

}  // namespace stepwire::live
