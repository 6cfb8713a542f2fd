#include "blocks/haptics/interval.hpp"

#include <fmt/core.h>

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Interval::configure(Configure& is) {
  for (Index i = 0; i < std::max(lower.size(), upper.size()); ++i) {
    const double low = lower[std::min(i, lower.size() - 1)], high = upper[std::min(i, upper.size() - 1)];
    if (!(low < high))
      is.refuse<&Interval::lower>(fmt::format("{} is not below the upper bound {}", low, high));
  }
}

void Interval::declare(Declare<Interval>& is) {
  is.block("Interval",
           {.doc = "1-D resistance map. Inside lower <= x <= upper both outputs are 0; outside, error is x "
                   "minus the bound that was passed, and depth its magnitude. A bound that is left out is "
                   "not there.",
            .source = "thesis 2.5.1, eq. 7",
            .symbol = {.curve = "M-1 -1L-.4 0H.4L1 1", .axes = true}});
  is.parameter<&Interval::lower>(
      {.unit = "'x", .doc = "lower bound of the authorized region; left out: none"});
  is.parameter<&Interval::upper>(
      {.unit = "'x", .doc = "upper bound of the authorized region; left out: none"});
  is.input<&Interval::x>({.unit = "'x", .doc = "position"});
  is.crossing<&Interval::x>("x reaches the lower bound");
  is.crossing<&Interval::x>("it reaches the upper bound");
  is.output<&Interval::depth>({.unit = "'x", .doc = "distance outside the region, never negative"});
  is.output<&Interval::error>(
      {.unit = "'x", .doc = "position error: positive above upper, negative below lower"});
}

}  // namespace stepwire
