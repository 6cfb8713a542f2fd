#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/simulate/realtime/histogram.hpp"

namespace stepwire::realtime {

/// Measurements of a loop at each deadline [ns]. A dropped deadline counts with its lateness when the loop
/// was ready again, and with the time until the next outputs. So a deadline that is not served cannot improve
/// the statistics.
class Measurements {
 public:
  /// `deadlines` is their total count, which divides the worst cases over time.
  explicit Measurements(std::int64_t deadlines) : deadlines_(deadlines), worst_(worst_count) {}

  /// Adds the lateness of the wake-up for deadline k.
  void woke(std::int64_t k, std::int64_t lateness) {
    wake_up_.add(lateness);
    raise(worst(k).wake_up, lateness);
  }
  /// Adds the time from deadline k until its outputs were written.
  void wrote(std::int64_t k, std::int64_t response) {
    response_.add(response);
    raise(worst(k).response, response);
  }
  /// Adds the time from the wake-up for deadline k until the thread was ready for the next one.
  void stepped(std::int64_t k, std::int64_t cost) {
    step_.add(cost);
    raise(worst(k).step, cost);
  }

  const Histogram& wake_up() const { return wake_up_; }
  const Histogram& response() const { return response_; }
  const Histogram& step() const { return step_; }

  /// Largest times in an interval of the loop's deadlines.
  struct Worst {
    std::int64_t wake_up = 0, step = 0, response = 0;
  };
  static constexpr std::size_t worst_count = 200;
  /// Returns the worst cases in order, each for an equal share of the deadlines.
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
