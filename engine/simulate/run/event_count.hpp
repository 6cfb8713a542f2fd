#pragma once

#include <algorithm>
#include <cstdint>

namespace stepwire::run {

/// Counts of the events that were located between ticks.
struct EventCount {
  std::int64_t located = 0, most_in_a_step = 0;

  EventCount& operator+=(const EventCount& other) {
    located += other.located;
    most_in_a_step = std::max(most_in_a_step, other.most_in_a_step);
    return *this;
  }
};

}  // namespace stepwire::run
