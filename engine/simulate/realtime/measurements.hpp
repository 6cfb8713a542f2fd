#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/simulate/realtime/histogram.hpp"

namespace stepwire::realtime {

/// What a loop measures at each of its deadlines [ns]. A deadline that was dropped counts with the lateness
/// that it had when the loop was ready again, and with the time until outputs were written next: what is not
/// served must not make the numbers better.
class Measurements {
 public:
  /// `deadlines`: how many there will be, for the worst cases over time.
  explicit Measurements(std::int64_t deadlines) : deadlines_(deadlines), worst_(worst_count) {}

  /// The thread was awake so long after deadline k.
  void woke(std::int64_t k, std::int64_t lateness) {
    wake_up_.add(lateness);
    raise(worst(k).wake_up, lateness);
  }
  /// Outputs were written so long after deadline k.
  void wrote(std::int64_t k, std::int64_t response) {
    response_.add(response);
    raise(worst(k).response, response);
  }
  /// All that the thread did for deadline k, from awake to ready for the next, took so long.
  void stepped(std::int64_t k, std::int64_t cost) {
    step_.add(cost);
    raise(worst(k).step, cost);
  }

  const Histogram& wake_up() const { return wake_up_; }
  const Histogram& response() const { return response_; }
  const Histogram& step() const { return step_; }

  /// The largest of each in a stretch of the loop's deadlines.
  struct Worst {
    std::int64_t wake_up = 0, step = 0, response = 0;
  };
  static constexpr std::size_t worst_count = 200;
  /// In order, each for an equal share of the deadlines.
  const std::vector<Worst>& worst() const { return worst_; }

 private:
  Worst& worst(std::int64_t k) {
    return worst_[static_cast<std::size_t>(k * static_cast<std::int64_t>(worst_count) / deadlines_)];
  }
  static void raise(std::int64_t& largest, std::int64_t value) { largest = std::max(largest, value); }

  std::int64_t deadlines_;
  Histogram wake_up_, response_, step_;
  std::vector<Worst> worst_;
};

}  // namespace stepwire::realtime
