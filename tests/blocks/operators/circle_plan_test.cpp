#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A point that moves as planned, about (3, 4) with radius 2, from (x, y) on.
Table led(const std::string& x, const std::string& y, const std::string& keys, const std::string& stop) {
  return run_text("step: 1 ms\nstop: " + stop +
                  "\nsolver: rk4\nblocks:\n  p: {block: Integrator, u: plan.velocity, initial: [" + x + ", " +
                  y + "]}\n  plan: {block: CirclePlan, position: p, center: [3 m, 4 m], radius: 2 m, " +
                  keys + ", every: 1 ms}\nrecord: [p, plan.turned, plan.velocity]\n");
}

}  // namespace

TEST_CASE("A hand that moves as planned goes around at the planned speed") {
  const Table run = led("5 m", "4 m", "speed: 1 m/s, correction: 4 Hz", "30 s");
  const auto &turned = column(run, "plan.turned"), &time = column(run, "time");
  for (std::size_t k = 0; k < time.size(); k += 100) REQUIRE(turned[k] == Approx(time[k] / 2.0).margin(1e-3));
  CHECK(turned.back() > 4.0 * M_PI);  // it counts more than one turn
}

TEST_CASE("A radial error falls by 1/e in one over the correction") {
  const Table run = led("7 m", "4 m", "speed: 0 m/s, correction: 4 Hz", "1 s");
  const auto &x = column(run, "p.1"), &time = column(run, "time");
  for (std::size_t k = 0; k < x.size(); ++k)
    REQUIRE(x[k] - 5.0 == Approx(2.0 * std::exp(-4.0 * time[k])).margin(5e-3));
}

TEST_CASE("The pace slows the way along, not the correction, and never turns it back") {
  const auto velocity = [](const std::string& pace) {
    const Table run = led("7 m", "4 m", "speed: 1 m/s, correction: 4 Hz, pace: " + pace, "1 ms");
    return std::pair(column(run, "plan.velocity.1").front(), column(run, "plan.velocity.2").front());
  };
  CHECK(velocity("1") == std::pair(-8.0, 1.0));
  CHECK(velocity("0.25") == std::pair(-8.0, 0.25));
  CHECK(velocity("-3") == std::pair(-8.0, 0.0));
}

TEST_CASE("In the centre the plan is finite") {
  const Table run = led("3 m", "4 m", "speed: 1 m/s, correction: 4 Hz", "3 s");
  CHECK(std::hypot(column(run, "p.1").back() - 3.0, column(run, "p.2").back() - 4.0) ==
        Approx(2.0).margin(1e-3));
}
