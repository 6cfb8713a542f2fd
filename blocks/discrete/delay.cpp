#include "blocks/discrete/delay.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire {

void Delay::declare(Declare<Delay>& is) {
  is.block(
      "Delay",
      {.doc = "Delay by a time: y(t) = u(t - delay), and `initial` until then. The delay is a whole number "
              "of the block's periods. Its output does not depend on its input at the same instant."});
  is.parameter<&Delay::delay>(
      {.unit = "s", .doc = "by how much, whole periods", .above = 0.0, .required = true});
  is.parameter<&Delay::initial>({.unit = "'u", .doc = "output before the first sample arrives"});
  is.input<&Delay::u>({.unit = "'u", .doc = "signal to delay", .feedthrough = false});
  is.output<&Delay::y>({.unit = "'u", .doc = "the input, `delay` ago"});
  is.state<&Delay::samples>(
      {.unit = "'u", .shape = "k x n", .doc = "samples on their way", .settable = false});
  is.state<&Delay::oldest>({.doc = "where the oldest sample stands", .settable = false});
}

void Delay::configure(Configure& is) {
  const double count = std::round(delay / is.period());
  if (count < 1.0 || std::abs(count * is.period() - delay) > 1e-9 * delay)
    is.refuse<&Delay::delay>(
        fmt::format("{} s is not a whole number of the block's period of {} s", delay, is.period()));
  if (count > 1e9)  // far beyond what a memory holds; casting still more is not defined
    is.refuse<&Delay::delay>(
        fmt::format("{} s is {} periods of {} s; at most 1e9 can be kept", delay, count, is.period()));
  periods = static_cast<Eigen::Index>(count);
  is.size("k", periods);
}

}  // namespace stepwire
