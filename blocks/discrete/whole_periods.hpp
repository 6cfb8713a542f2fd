#pragma once

#include <fmt/format.h>

#include <cmath>

#include "engine/model/block/configure.hpp"

namespace stepwire {

/// How many of the block's periods a time is [s]; refuses the parameter that gave it where it is no whole
/// number of them, or more than any memory keeps.
template <auto parameter>
Index whole_periods(const Configure& is, double time) {
  const double count = std::round(time / is.period());
  if (count < 1.0 || std::abs(count * is.period() - time) > 1e-9 * time)
    is.refuse<parameter>(
        fmt::format("{} s is not a whole number of the block's period of {} s", time, is.period()));
  if (count > 1e9)  // casting still more is not defined
    is.refuse<parameter>(
        fmt::format("{} s is {} periods of {} s; at most 1e9 can be kept", time, count, is.period()));
  return static_cast<Index>(count);
}

}  // namespace stepwire
