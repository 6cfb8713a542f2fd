#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Answer of the block to a single 1 at 10 ms among zeros, at every millisecond from there on: its
/// coefficients, the one of this tick first.
std::vector<double> impulse_answer(const std::string& keys, std::size_t count) {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 40 ms\nblocks:\n  u: {block: Expression, u: clock, expression: \"abs(u - 0.01) < "
      "1e-4 ? 1 "
      ": "
      "0\"}\n  clock: {block: Clock}\n  y: {block: SavitzkyGolay, u: u, every: 1 ms, " +
      keys + "}\nrecord: [y]\n");
  const auto& y = column(table, "y");
  return {y.begin() + 10, y.begin() + 10 + static_cast<std::ptrdiff_t>(count)};
}

void check_near(const std::vector<double>& values, const std::vector<double>& expected, double scale) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK(values[i] == Approx(expected[i] * scale).margin(1e-12 * std::abs(scale)));
}

/// p(t) = 1 + 2 t - 30 t^2 + 400 t^3
std::string cubic(const std::string& keys) {
  return "step: 10 ms\nstop: 1 s\nblocks:\n  t: {block: Clock}\n  p: {block: Polynomial, u: t, coefficients: "
         "[400, "
         "-30, 2, 1]}\n  y: {block: SavitzkyGolay, u: p, every: 10 ms, " +
         keys + "}\nrecord: [y]\n";
}

}  // namespace

// Savitzky and Golay's tables, Anal. Chem. 36 (1964) 1627; the newest sample first.
TEST_CASE("the coefficients are the published ones") {
  check_near(impulse_answer("window: 5, order: 2", 6), {-3, 12, 17, 12, -3, 0}, 1.0 / 35.0);
  check_near(impulse_answer("window: 5, order: 3", 5), {-3, 12, 17, 12, -3}, 1.0 / 35.0);
  check_near(impulse_answer("window: 7, order: 2", 7), {-2, 3, 6, 7, 6, 3, -2}, 1.0 / 21.0);
  check_near(impulse_answer("window: 9, order: 4", 9), {15, -55, 30, 135, 179, 135, 30, -55, 15},
             1.0 / 429.0);
  check_near(impulse_answer("window: 5, order: 2, derivative: 1", 6), {2, 1, 0, -1, -2, 0}, 1e3 / 10.0);
  check_near(impulse_answer("window: 5, order: 3, derivative: 1", 5), {-1, 8, 0, -8, 1}, 1e3 / 12.0);
  check_near(impulse_answer("window: 5, order: 2, derivative: 2", 5), {2, -1, -2, -1, 2}, 1e6 / 7.0);
}

TEST_CASE("polynomials up to the order pass exactly, late by half of the window") {
  const std::string keys = "window: 11, order: 3, derivative: ";
  const auto value = column(run_text(cubic(keys + "0")), "y"),
             slope = column(run_text(cubic(keys + "1")), "y"),
             bend = column(run_text(cubic(keys + "2")), "y");
  for (std::size_t k = 10; k < value.size(); ++k) {
    const double t = 0.01 * static_cast<double>(k) - 0.05;
    REQUIRE(value[k] == Approx(1.0 + 2.0 * t - 30.0 * t * t + 400.0 * t * t * t).epsilon(1e-10));
    REQUIRE(slope[k] == Approx(2.0 - 60.0 * t + 1200.0 * t * t).epsilon(1e-9).margin(1e-9));
    REQUIRE(bend[k] == Approx(-60.0 + 2400.0 * t).epsilon(1e-8).margin(1e-7));
  }
}

TEST_CASE("a long window of high order is as exact") {
  const auto y = column(run_text(cubic("window: 101, order: 9")), "y");
  REQUIRE(y.at(100) == Approx(1.0 + 2.0 * 0.5 - 30.0 * 0.25 + 400.0 * 0.125).epsilon(1e-9));
}

TEST_CASE("each element of a vector is smoothed by itself, and a constant from the first tick on") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 20 ms
blocks:
  u: {block: Constant, value: [3, -4]}
  y: {block: SavitzkyGolay, u: u, every: 1 ms, window: 7}
  slope: {block: SavitzkyGolay, u: u, every: 1 ms, window: 7, derivative: 1}
record: [y, slope]
)");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    CHECK(column(table, "y.1")[k] == Approx(3.0).epsilon(1e-12));
    CHECK(column(table, "y.2")[k] == Approx(-4.0).epsilon(1e-12));
    CHECK(column(table, "slope.2")[k] == Approx(0.0).margin(1e-10));
  }
}

TEST_CASE("a derivative has its unit") {
  const auto fed_to_length = [](const std::string& derivative) {
    return error_of(
        "step: 1 ms\nstop: 1 ms\nblocks:\n  x: {block: Constant, value: 1 m}\n  y: {block: SavitzkyGolay, u: "
        "x, every: "
        "1 ms, derivative: " +
        derivative + "}\n  sum: {block: Sum, u: [x, y]}\n");
  };
  CHECK(fed_to_length("0").empty());
  CHECK_THAT(fed_to_length("1"), Catch::Contains("m/s"));
  CHECK_THAT(fed_to_length("2"), Catch::Contains("m/s"));
}

TEST_CASE("a window without a middle, or a polynomial that fits it as it is, is refused") {
  CHECK_THAT(error_of(cubic("window: 6")), Catch::Contains("y.window") && Catch::Contains("e.g. 7"));
  CHECK_THAT(error_of(cubic("window: 5, order: 5")), Catch::Contains("y.order"));
  CHECK_THAT(error_of(cubic("order: 1, derivative: 2")), Catch::Contains("y.derivative"));
}
