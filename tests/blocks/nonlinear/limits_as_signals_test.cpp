#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("Limits of Saturation and DeadZone may be signals, one of them or both") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 2 s
solver: euler
blocks:
  u: {block: Sine, amplitude: 3 N, frequency: 1 Hz}
  top: {block: Ramp, slope: 1 N/s}
  bottom: {block: Gain, u: top, gain: -0.5}
  both: {block: Saturation, u: u, lower: bottom, upper: top}
  one: {block: Saturation, u: u, lower: -1 N, upper: top}
  zone: {block: DeadZone, u: u, lower: bottom, upper: top}
record: [u, top, both, one, zone]
)");
  for (std::size_t k = 0; k <= 200; ++k) {
    const double u = column(table, "u")[k], top = column(table, "top")[k];
    CHECK(column(table, "both")[k] == std::min(std::max(u, -0.5 * top), top));
    CHECK(column(table, "one")[k] == std::min(std::max(u, -1.0), top));
    CHECK(column(table, "zone")[k] == u - std::min(std::max(u, -0.5 * top), top));
  }
}

TEST_CASE("A limit that is a signal has the unit of the signal that it limits") {
  const std::string text = error_of(R"(
step: 10 ms
stop: 2 s
solver: euler
blocks:
  u: {block: Constant, value: 3 N}
  top: {block: Constant, value: 1 m}
  s: {block: Saturation, u: u, upper: top}
record: [s]
)");
  CHECK(text.find("s.upper") != std::string::npos);
}

TEST_CASE("A limit that names nothing is a value, and refused as one") {
  CHECK(error_of("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
                 "  s: {block: Saturation, u: 1, upper: nothing}\nrecord: [s]\n")
            .find("nothing") != std::string::npos);
}

TEST_CASE("Rates of RateLimiter may be signals; a wrong sign stands still") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 2 s
solver: euler
blocks:
  rate: {block: Step, time: 1 s, before: 2 m/s, after: -1 m/s}
  s: {block: RateLimiter, u: 10 m, rising: rate}
record: [s]
)");
  CHECK(column(table, "s")[100] == Approx(1.98).epsilon(1e-12));
  CHECK(column(table, "s")[200] == Approx(1.98).epsilon(1e-12));
}
