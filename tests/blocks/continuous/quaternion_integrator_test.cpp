#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A steady turn is a half angle about its axis, and its length stays 1") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 5 s
solver: rk4
blocks:
  w: {block: Constant, value: {value: [0.6, -0.2, 0.9], unit: rad/s}}
  q: {block: QuaternionIntegrator, rate: w}
record: [q]
)");
  const double rate = std::sqrt(0.36 + 0.04 + 0.81);
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 100) {
    const double half = 0.5 * rate * time[k];
    CHECK(column(table, "q.1")[k] == Approx(std::cos(half)).margin(1e-12));
    CHECK(column(table, "q.2")[k] == Approx(std::sin(half) * 0.6 / rate).margin(1e-12));
    CHECK(column(table, "q.3")[k] == Approx(std::sin(half) * -0.2 / rate).margin(1e-12));
    CHECK(column(table, "q.4")[k] == Approx(std::sin(half) * 0.9 / rate).margin(1e-12));
  }
}

TEST_CASE("The turned frame and the fixed one differ by the order of the turns") {
  // Half a second about x at 1 rad/s, then about z at 2 rad/s. Turns about the turned axes give q = qx qz,
  // turns about the fixed axes q = qz qx.
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  wx: {block: Step, time: 0.5 s, before: 1 rad/s, after: 0 rad/s, every: 1 ms}
  wz: {block: Step, time: 0.5 s, before: 0 rad/s, after: 2 rad/s, every: 1 ms}
  zero: {block: Constant, value: 0 rad/s}
  w: {block: Mux, u: [wx, zero, wz]}
  turned: {block: QuaternionIntegrator, rate: w}
  fixed: {block: QuaternionIntegrator, rate: w, frame: fixed}
record: [turned, fixed]
)");
  const double c1 = std::cos(0.25), s1 = std::sin(0.25), c2 = std::cos(0.5), s2 = std::sin(0.5);
  const double turned[] = {c1 * c2, s1 * c2, -s1 * s2, c1 * s2},
               fixed[] = {c1 * c2, s1 * c2, s1 * s2, c1 * s2};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(column(table, fmt::format("turned.{}", k + 1)).back() == Approx(turned[k]).margin(1e-12));
    CHECK(column(table, fmt::format("fixed.{}", k + 1)).back() == Approx(fixed[k]).margin(1e-12));
  }
}
