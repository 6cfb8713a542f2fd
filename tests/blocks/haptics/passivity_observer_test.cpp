#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A port that is moved as x = 10 mm sin(w t), w = 2 pi rad/s, and resists with this force.
table::Table moved(const std::string& force, const std::string& keys) {
  return run_text(
      "step: 1 ms\nstop: 2.25 s\nsolver: rk4\nblocks:\n  x: {block: Sine, amplitude: 10 mm, frequency: 1 "
      "Hz}\n"
      "  v: {block: Sine, amplitude: = 10 mm*2*pi*1 Hz, frequency: 1 Hz, phase: 90 deg}\n" +
      force + "  port: {block: PassivityObserver, force: force, velocity: v" + keys +
      "}\nrecord: [x, v, port.supplied, port.dissipated, port.least_gain, port.broken]\n");
}

const std::string spring =
    "  force: {block: Gain, u: x, gain: 200 N/m}\n  stored: {block: Expression, u: x, expression: "
    "100*u1^2}\n";
const std::string dashpot = "  force: {block: Gain, u: v, gain: 5 N s/m}\n";
const std::string source = "  force: {block: Gain, u: v, gain: -5 N s/m}\n";
constexpr double w = 2.0 * M_PI, amplitude = 0.01;

/// Energy of a dashpot of 5 N s/m: the integral of 5 v^2.
double lost_after(double t) {
  return 5.0 * amplitude * amplitude * w * w * (t / 2.0 + std::sin(2.0 * w * t) / (4.0 * w));
}

std::size_t first(const std::vector<double>& truth) {
  std::size_t k = 0;
  while (k < truth.size() && truth[k] == 0.0) ++k;
  return k;
}

}  // namespace

TEST_CASE("A spring stores what is supplied: k x^2 / 2, and nothing is dissipated") {
  const table::Table table = moved(spring, ", stored: stored, judge: fall, budget: 1e-9 J");
  for (std::size_t k = 0; k < column(table, "x").size(); k += 50) {
    const double x = column(table, "x")[k];
    CHECK(column(table, "port.supplied")[k] == Approx(100.0 * x * x).margin(1e-10));
    CHECK(column(table, "port.dissipated")[k] == Approx(0.0).margin(1e-10));
  }
  CHECK(first(column(table, "port.broken")) == 2251);
}

TEST_CASE("A dashpot dissipates all that is supplied, and never gives any of it back") {
  const table::Table table = moved(dashpot, ", judge: fall, budget: 1e-12 J");
  CHECK(column(table, "port.supplied").back() == Approx(lost_after(2.25)).epsilon(1e-9));
  CHECK(column(table, "port.dissipated").back() == column(table, "port.supplied").back());
  CHECK(column(table, "port.least_gain").back() > -1e-15);
  CHECK(first(column(table, "port.broken")) == 2251);
}

TEST_CASE("An active source breaks the balance when it has given out the budget") {
  const double budget = 0.01;
  const table::Table table = moved(source, ", budget: 10 mJ");
  const auto tick = static_cast<double>(first(column(table, "port.broken")));
  CHECK(lost_after(1e-3 * tick) > budget);
  CHECK(lost_after(1e-3 * (tick - 1.0)) <= budget);
  // in a millisecond it gives out 5 v^2 dt at most
  CHECK(column(table, "port.least_gain").back() ==
        Approx(-5.0 * amplitude * amplitude * w * w * 1e-3).epsilon(1e-4));
}

TEST_CASE("Several axes have one account") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  port: {block: PassivityObserver, force: [3 N, -4 N], velocity: [2 m/s, 0.5 m/s]}
record: [port.supplied]
)");
  CHECK(column(table, "port.supplied").back() == Approx(4.0).epsilon(1e-12));
}

TEST_CASE(
    "A source behind a dashpot is noticed by the fall of what was dissipated, and late by the net balance") {
  // a dashpot for 1 s, then as strong a source
  const auto at = [&](const std::string& judge) {
    return first(column(
        run_text("step: 1 ms\nstop: 3 s\nsolver: rk4\nblocks:\n  v: {block: Sine, amplitude: "
                 "1, frequency: 1 Hz}\n  sign: "
                 "{block: Step, time: 1 s, before: 5 N s/m, after: -5 N s/m}\n  force: {block: Product, "
                 "u: [v, sign]}\n  port: {block: "
                 "PassivityObserver, force: force, velocity: v, judge: " +
                 judge + ", budget: 0.1 J}\nrecord: [port.broken]\n"),
        "port.broken"));
  };
  // the integral of 5 sin^2(2 pi t) over a second is 2.5; 0.1 is reached at 2 pi t - sin(2 pi t) cos(2 pi t)
  // = 0.08 pi
  CHECK(at("fall") > 1000);
  CHECK(at("fall") < 1130);
  CHECK(at("net") >= 2000);
  CHECK(at("net") < 2130);
}

TEST_CASE("Stored energy at the start is nobody's gain, and booked work is dissipated like supplied work") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  stored: {block: Ramp, slope: 2 W, initial: 5 J}
  booked: {block: Ramp, slope: 3 W}
  port: {block: PassivityObserver, force: 1 N, velocity: 4 m/s, stored: stored, booked: booked, judge: fall, budget: 1e-9 J}
record: [port.dissipated, port.least_gain, port.broken]
)");
  CHECK(column(table, "port.dissipated").front() == 0.0);
  CHECK(column(table, "port.dissipated").back() == Approx(4.0 + 3.0 - 2.0).epsilon(1e-9));
  CHECK(column(table, "port.least_gain").back() == 0.0);
  CHECK(column(table, "port.broken").back() == 0.0);
}
