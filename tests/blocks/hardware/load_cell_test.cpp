#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A cell whose gauges are 1 to 6 V for one newton or newton metre each, crosswise in two pairs.
const std::string simple =
    ", calibration: [[0, 1, 0, 0, 0, 0], [0.5, 0, 0, 0, 0, 0], [0, 0, 0.25, 0, 0, 0], [0, 0, 0, 0.125, 0, "
    "0], "
    "[0, 0, 0, 0, 0, 2], [0, 0, 0, 0, 4, 0]]";

table::Table loaded(const std::string& load, const std::string& cell, const std::string& reading,
                    const std::string& stop = "10 ms") {
  return run_text("step: 1 ms\nstop: " + stop + "\nblocks:\n  cell: {block: LoadCell, seed: 1, " + load +
                  cell + "}\n  reading: {block: LoadCellToWrench, gauges: cell" + reading +
                  "}\nrecord: [cell, reading.force, reading.torque, reading.saturated]\n");
}

std::vector<double> read(const table::Table& table) {
  std::vector<double> wrench;
  for (const std::string what : {"force", "torque"})
    for (const std::string axis : {".1", ".2", ".3"})
      wrench.push_back(column(table, "reading." + what + axis).back());
  return wrench;
}

const std::string load = "force: [3 N, -2 N, 1 N], torque: [0.5 N m, 4 N m, -8 N m]";
const std::vector<double> of_load{3, -2, 1, 0.5, 4, -8};

}  // namespace

TEST_CASE("The gauges of a load cell show its load by the inverse of the calibration") {
  const table::Table table = loaded(load, simple, simple);
  const std::vector<double> volts{-4, 3, 4, 4, -2, 2};
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(column(table, "cell." + std::to_string(i + 1)).back() == Approx(volts[i]).epsilon(1e-12));
}

TEST_CASE("What a load cell shows is read as its load, whichever calibration it has") {
  for (const std::string keys : {simple, std::string(", preset: ati-mini40-si-80-4, noise: 0 V"),
                                 std::string(", preset: ati-mini40-si-40-2, noise: 0 V")}) {
    const std::string small = "force: [3 N, -2 N, 1 N], torque: [0.5 N m, 0.4 N m, -0.8 N m]";
    const std::string reading = keys.substr(0, keys.find(", noise"));
    const std::vector<double> wanted{3, -2, 1, 0.5, 0.4, -0.8};
    const table::Table table = loaded(small, keys, reading);
    for (std::size_t i = 0; i < 6; ++i) CHECK(read(table)[i] == Approx(wanted[i]).epsilon(1e-12));
  }
}

TEST_CASE("A tare takes out what the gauges show without a load, and the mean of their noise") {
  const std::string text =
      "step: 1 ms\nstop: 2 s\nblocks:\n  clock: {block: Clock}\n  taring: {block: Compare, u: clock, "
      "operator: less, "
      "to: 1 s}\n  push: {block: Step, time: 1 s, after: [3 N, -2 N, 1 N]}\n  cell: {block: LoadCell, force: "
      "push, "
      "torque: [0, 0, 0], offset: [1 V, -2 V, 0.5 V, 0, 0, 3 V], noise: 10 mV, seed: 1" +
      simple + "}\n  reading: {block: LoadCellToWrench, gauges: cell, tare: taring" + simple +
      "}\nrecord: [reading.force, reading.torque]\n";
  const table::Table table = run_text(text);
  const std::vector<double> load{3, -2, 1, 0, 0, 0}, per_volt{1, 0.5, 0.25, 0.125, 2, 4};
  std::size_t axis = 0;
  for (const std::string name : {"reading.force.1", "reading.force.2", "reading.force.3", "reading.torque.1",
                                 "reading.torque.2", "reading.torque.3"}) {
    double mean = 0.0;
    for (std::size_t k = 1001; k <= 2000; ++k) mean += column(table, name)[k] / 1000.0;
    // both means are of 1000 samples of 10 mV
    CHECK(mean == Approx(load[axis]).margin(4.0 * 0.01 * std::sqrt(2.0 / 1000.0) * per_volt[axis]));
    ++axis;
  }
}

TEST_CASE("A load cell beyond its range shows the end of it, and the reading says so") {
  const table::Table much = loaded("force: [11 N, 0 N, 0 N], torque: [0, 0, 0]", simple, simple);
  CHECK(column(much, "cell.2").back() == 10.0);
  CHECK(read(much)[0] == 10.0);
  CHECK(column(much, "reading.saturated").back() == 1.0);
  const table::Table less = loaded("force: [9 N, 0 N, 0 N], torque: [0, 0, 0]", simple, simple);
  CHECK(column(less, "reading.saturated").back() == 0.0);
}

TEST_CASE("A Mini40 SI-80-4 takes its full load on all axes at once, and has the noise that was measured") {
  const std::string keys = ", preset: ati-mini40-si-80-4";
  const table::Table full =
      loaded("force: [80 N, -80 N, 240 N], torque: [4 N m, 4 N m, -4 N m]", keys + ", noise: 0 V", keys);
  CHECK(column(full, "reading.saturated").back() == 0.0);
  CHECK(read(full)[0] == Approx(80.0).epsilon(1e-9));
  const table::Table table = loaded("force: [0, 0, 0], torque: [0, 0, 0]", keys, keys, "5 s");
  for (const std::string axis : {"reading.force.1", "reading.force.2"}) {
    double squares = 0.0;
    for (double force : column(table, axis)) squares += force * force;
    CHECK(std::sqrt(squares / 5001.0) == Approx(0.015).epsilon(0.05));
  }
}

TEST_CASE("A calibration that is none is refused") {
  const auto error = [](const std::string& keys) {
    return error_of(
        "step: 1 ms\nstop: 1 ms\nblocks:\n  c: {block: LoadCell, force: [0, 0, 0], torque: [0, 0, 0], "
        "seed: 1" +
        keys + "}\n");
  };
  CHECK_THAT(error(""), Catch::Contains("c.calibration") && Catch::Contains("six rows"));
  std::string rows = "[1, 2, 3, 4, 5, 6]";
  for (int k = 1; k < 6; ++k) rows += ", [1, 2, 3, 4, 5, 6]";
  CHECK_THAT(error(", calibration: [" + rows + "]"), Catch::Contains("has no inverse"));
}
