#pragma once

#include <fmt/format.h>

#include <cmath>

#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Returns a time [s] in periods of the block. Refuses the parameter if it is no whole number of periods, or
/// more than memory could store.
template <auto parameter>
Index whole_periods(const Configure& is, double time) {
  const double count = std::round(time / is.period());
  if (count < 1.0 || std::abs(count * is.period() - time) > 1e-9 * time)
    is.refuse<parameter>(
        fmt::format("{} s is not a whole number of the block's period of {} s", time, is.period()));
  if (count > 1e9)  // the cast of larger numbers is undefined
    is.refuse<parameter>(
        fmt::format("{} s is {} periods of {} s; at most 1e9 can be kept", time, count, is.period()));
  return static_cast<Index>(count);
}

}  // namespace stepwire
