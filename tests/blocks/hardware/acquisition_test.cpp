#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Returns a ramp from -12 to 12 V, its counts and the voltage converted back from them.
table::Table converted(const std::string& keys) {
  return run_text(
      "step: 1 ms\nstop: 24 s\nblocks:\n  volts: {block: Ramp, slope: 1 V/s, initial: -12 V}\n"
      "  counts: {block: AnalogToDigital, u: volts" +
      keys + "}\n  back: {block: DigitalToAnalog, counts: counts" + keys +
      "}\nrecord: [volts, counts, back]\n");
}

}  // namespace

TEST_CASE("A converter of 14 bits over -10 to 10 V has 16384 levels, and the last one beyond its ends") {
  const table::Table table = converted(", preset: sensoray-626");
  const auto& counts = column(table, "counts");
  CHECK(counts.front() == -8192.0);
  CHECK(counts.back() == 8191.0);
  CHECK(counts[17000] == 4096.0);  // 5 V
  for (std::size_t k = 1; k < counts.size(); ++k) {
    REQUIRE(counts[k] == std::floor(counts[k]));
    REQUIRE(counts[k] >= counts[k - 1]);
  }
}

TEST_CASE("Counts tell a voltage within the range to half a level") {
  for (const std::string keys : {", range: 5 V, bits: 12", ", preset: sensoray-626"}) {
    const bool fine = keys.find("626") != std::string::npos;
    const double range = fine ? 10.0 : 5.0, level = 2.0 * range / (fine ? 16384.0 : 4096.0);
    const table::Table table = converted(keys);
    double worst = 0.0;
    for (std::size_t k = 0; k < column(table, "time").size(); ++k)
      if (std::abs(column(table, "volts")[k]) < range - level)
        worst = std::max(worst, std::abs(column(table, "back")[k] - column(table, "volts")[k]));
    CHECK(worst <= 0.5 * level * (1.0 + 1e-6));
    CHECK(worst > 0.4 * level);
    CHECK(column(table, "back").back() == Approx(range - level));
    CHECK(column(table, "back").front() == -range);
  }
}

TEST_CASE("What is no level of a converter becomes the nearest one") {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 1 ms\nblocks:\n  y: {block: DigitalToAnalog, counts: [0.4, -0.6, "
      "1e6, -1e6], range: 8 V, bits: 4}\nrecord: [y]\n");
  CHECK(column(table, "y.1").back() == 0.0);
  CHECK(column(table, "y.2").back() == -1.0);
  CHECK(column(table, "y.3").back() == 7.0);
  CHECK(column(table, "y.4").back() == -8.0);
}
