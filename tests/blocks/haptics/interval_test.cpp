#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table over_x(const std::string& map) {
  return run_text(
      "step: 1 ms\nstop: 20 s\nblocks:\n  x: {block: Ramp, slope: 1 mm/s, initial: -10 mm}\n  map: {block: "
      "Interval, x: x" +
      map + "}\nrecord: {every: 0.5 s, signals: [x, map.depth, map.error]}\n");
}

}  // namespace

TEST_CASE("An interval gives the signed distance to the bound that was passed") {
  const table::Table table = over_x(", lower: -4 mm, upper: 5 mm");
  const auto& x = column(table, "x");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double wanted = std::max(0.0, x[k] - 5e-3) + std::min(0.0, x[k] + 4e-3);
    CHECK(column(table, "map.error")[k] == Approx(wanted).margin(1e-15));
    CHECK(column(table, "map.depth")[k] == std::abs(column(table, "map.error")[k]));
  }
}

TEST_CASE("An interval without an upper bound is open there") {
  const table::Table table = over_x(", lower: -4 mm");
  CHECK(column(table, "map.error").front() == Approx(-6e-3));
  CHECK(column(table, "map.error").back() == 0.0);
}

TEST_CASE("An interval with exchanged bounds is refused") {
  CHECK_THAT(
      error_of(
          "step: 1 ms\nstop: 1 s\nblocks:\n  map: {block: Interval, x: 0 m, lower: 5 mm, upper: -4 mm}\n"),
      Catch::Contains("map.lower") && Catch::Contains("upper bound"));
}
