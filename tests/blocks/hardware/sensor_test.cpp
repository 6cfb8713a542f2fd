#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string head =
    "step: 1 ms\nstop: 10 s\nblocks:\n  u: {block: Ramp, slope: 10 mm/s, initial: -10 mm}\n";

/// Returns the reading of a sensor for a ramp from -10 to 90 mm, beside the ramp.
table::Table on_ramp(const std::string& keys) {
  return run_text(head + "  y: {block: Sensor, u: u, " + keys + "}\nrecord: [u, y]\n");
}

double largest_error(const table::Table& table, double from, double to) {
  const auto &u = column(table, "u"), &y = column(table, "y");
  double worst = 0.0;
  for (std::size_t k = 0; k < u.size(); ++k)
    if (u[k] >= from && u[k] <= to) worst = std::max(worst, std::abs(y[k] - u[k]));
  return worst;
}

}  // namespace

TEST_CASE("A sensor of which nothing is said shows what it is fed") {
  const table::Table table = on_ramp("seed: 1");
  CHECK(column(table, "y") == column(table, "u"));
}

TEST_CASE("A sensor shows the end of its range beyond it") {
  const table::Table table = on_ramp("seed: 1, lower: 0 mm, upper: 75 mm");
  CHECK(column(table, "y").front() == 0.0);
  CHECK(column(table, "y").back() == 0.075);
  CHECK(largest_error(table, 0.0, 0.075) == 0.0);
}

TEST_CASE("A sensor is off its straight line by its linearity, and right at both ends and in the middle") {
  const table::Table table = on_ramp("seed: 1, lower: 0 mm, upper: 80 mm, linearity: 0.01");
  CHECK(largest_error(table, 0.0, 0.08) == Approx(0.8e-3).epsilon(1e-9));
  CHECK(largest_error(table, 0.0399999, 0.0400001) < 1e-9);
  CHECK(largest_error(table, 0.0799999, 0.0800001) < 1e-9);
}

TEST_CASE("A converter of 14 bits shows multiples of its range over 16384, the nearest ones") {
  const table::Table table = on_ramp("seed: 1, converter_range: 150 mm, bits: 14");
  const double interval = 0.150 / 16384.0;
  for (double y : column(table, "y")) REQUIRE(std::abs(y / interval - std::round(y / interval)) < 1e-9);
  CHECK(largest_error(table, -1.0, 1.0) == Approx(interval / 2.0).epsilon(0.01));
}

TEST_CASE("The noise of a sensor has its deviation, no mean, and a sequence for each seed and element") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 20 s
blocks:
  a: {block: Sensor, u: [5, 5], noise: 0.3, seed: 1}
  b: {block: Sensor, u: 5, noise: 0.3, seed: 2}
record: [a, b]
)");
  const auto &a1 = column(table, "a.1"), &a2 = column(table, "a.2"), &b = column(table, "b");
  double sum = 0.0, squares = 0.0, with_element = 0.0, with_seed = 0.0;
  const auto count = static_cast<double>(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    sum += a1[k] - 5.0;
    squares += (a1[k] - 5.0) * (a1[k] - 5.0);
    with_element += (a1[k] - 5.0) * (a2[k] - 5.0);
    with_seed += (a1[k] - 5.0) * (b[k] - 5.0);
  }
  CHECK(std::abs(sum / count) < 4.0 * 0.3 / std::sqrt(count));
  CHECK(std::sqrt(squares / count) == Approx(0.3).epsilon(0.02));
  CHECK(std::abs(with_element / count) < 4.0 * 0.09 / std::sqrt(count));
  CHECK(std::abs(with_seed / count) < 4.0 * 0.09 / std::sqrt(count));
}

TEST_CASE("The mounting of a sensor moves its range") {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 0.01 s\nblocks:\n  y: {block: Sensor, u: 260 mm, zero: 190 mm, lower: 0 mm, upper: "
      "60 "
      "mm, seed: 1}\nrecord: [y]\n");
  CHECK(column(table, "y").back() == Approx(0.25).epsilon(1e-12));
}

TEST_CASE("A number of a sensor that is none ends the run at once, with its place") {
  // The cable breaks after half a second.
  const std::string message = error_of(R"yaml(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  clock:   {block: Clock}
  length:  {block: Sensor, u: 200 mm, seed: 1, every: 10 ms}
  cable:   {block: Expression, expression: "u1 + 0*sqrt(0.495 - u2)", u: [length, clock], every: 10 ms}
  current: {block: Gain, u: cable, gain: 0.1 A/m}
  damper:  {block: MRDamper, velocity: 10 mm/s, current: current}
)yaml");
  CHECK_THAT(message, Catch::Contains("cable") && Catch::Contains("became nan at 0.5 s; the run ends here"));
}

TEST_CASE("What is no sensor is refused with the reason") {
  const auto error = [](const std::string& keys) {
    return error_of("step: 1 ms\nstop: 1 s\nblocks:\n  s: {block: Sensor, u: 1 mm, seed: 1, " + keys + "}\n");
  };
  CHECK_THAT(error("lower: 2 mm, upper: 1 mm"), Catch::Contains("s.lower"));
  CHECK_THAT(error("linearity: 0.01"),
             Catch::Contains("s.linearity") && Catch::Contains("share of the range"));
  CHECK_THAT(error("bits: 14"), Catch::Contains("s.bits") && Catch::Contains("converter_range"));
  CHECK_THAT(error("converter_range: 1 m"), Catch::Contains("s.bits") && Catch::Contains("no converter"));
  CHECK_THAT(error_of("step: 1 ms\nstop: 1 s\nblocks:\n  s: {block: Sensor, u: 1 mm}\n"),
             Catch::Contains("seed"));
}
