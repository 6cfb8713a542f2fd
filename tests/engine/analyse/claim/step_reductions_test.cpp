#include "engine/analyse/claim/reduce.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace stepwire::claim {

namespace {

/// A step of a second-order system with damping 0.5 and 10 rad/s, from 1 to 3, every millisecond for 4 s.
Rows second_order() {
  const double damping = 0.5, w = 10.0, wd = w * std::sqrt(1 - damping * damping);
  Rows rows;
  for (int k = 0; k <= 4000; ++k) {
    const double t = 1e-3 * k;
    rows.time.push_back(t + 7.0);
    rows.value.push_back(
        1 + 2 * (1 - std::exp(-damping * w * t) * (std::cos(wd * t) + damping * w / wd * std::sin(wd * t))));
  }
  rows.selected.assign(rows.value.size(), true);
  rows.starts = {0};
  return rows;
}

}  // namespace

// octave: pkg load control; s = stepinfo(tf(100, [1 10 100])): no such verb in 3.4; scipy: by brentq on the
// closed form: rise 0.163757 s, settling 0.807635 s.
TEST_CASE("what a step of a second-order system does is what its closed form says") {
  const Rows rows = second_order();
  CHECK(reduce_step(Reduction::overshoot, rows) ==
        Approx(std::exp(-std::numbers::pi * 0.5 / std::sqrt(0.75))).epsilon(1e-5));
  CHECK(reduce_step(Reduction::peak_time, rows) ==
        Approx(std::numbers::pi / (10.0 * std::sqrt(0.75))).margin(6e-4));
  CHECK(reduce_step(Reduction::rise_time, rows) == Approx(0.163757).margin(5e-6));
  CHECK(reduce_step(Reduction::settling_time, rows) == Approx(0.807635).margin(5e-6));
}

TEST_CASE("integral and final error are those of the signal as it is") {
  Rows rows{{2, -1, -1, 3}, {}, {0, 1, 2, 4}, {true, true, true, true}, {0}};
  CHECK(reduce_step(Reduction::iae, rows) == Approx(1.5 + 1.0 + 4.0));
  CHECK(reduce_step(Reduction::steady_error, rows) == 3.0);
  rows.selected[3] = false;
  CHECK(reduce_step(Reduction::steady_error, rows) == 1.0);
}

TEST_CASE("a signal that ends where it began has no step") {
  const Rows rows{{1, 2, 1}, {}, {0, 1, 2}, {true, true, true}, {0}};
  CHECK(std::isnan(reduce_step(Reduction::rise_time, rows)));
}

}  // namespace stepwire::claim
