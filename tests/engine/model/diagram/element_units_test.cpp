#include <catch2/catch.hpp>

#include "engine/model/diagram/units.hpp"
#include "tests/engine/model/diagram/units_of.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string pendulum =
    "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  hold: {block: Mass, mass: 1 kg, force: 1 N}\n  x: "
    "{block: Ramp, slope: 1 mm/s}\n  theta: {block: Ramp, slope: 2 deg/s}\n"
    "  y: {block: Mux, u: [x, theta]}\n";
const std::string filter =
    "  kf: {block: KalmanFilter, measured: y, every: 1 ms, A: [[1, 0], [0, 1]], C: [[1, 0], [0, 1]], "
    "Q: [[1, 0], [0, 1]], R: [[1, 0], [0, 1]]}\n";

}  // namespace

TEST_CASE("a Mux joins signals of different units, and each element keeps its own") {
  CHECK(units_of(pendulum, "y") == "m, rad");
  CHECK(units_of(pendulum + "  late: {block: UnitDelay, u: y, every: 1 ms}\n", "late") == "m, rad");
  CHECK(units_of(pendulum + "  one: {block: Gain, u: y.1, gain: 2 N/m}\n", "one") == "N");
  CHECK(faults_of(pendulum + "  f: {block: Mass, mass: 1 kg, force: y.1}\n").at(0) ==
        "test.yaml:9:39: f.force: y is in m, but f.force is in N; connect a signal in N, or put a Gain in "
        "N/m between them");
  CHECK(faults_of(pendulum + "  c: {block: Compare, u: y, operator: greater, to: 1 N}\n").size() == 1);
}

TEST_CASE("a Mux gives no unit to a signal without one, and a gain that is left out is a pure number") {
  const std::string late =
      "  late: {block: Lag, u: theta, tau: 0.1 s}\n  other: {block: Gain, u: theta, gain: 3}\n";
  CHECK(units_of(pendulum + late, "late") == "rad");
  CHECK(units_of(pendulum + late + "  z: {block: Mux, u: [x, late]}\n", "z") == "m, rad");
  CHECK(units_of(pendulum + late + "  z: {block: Mux, u: [x, other, x]}\n", "z") == "m, ?, m");
  CHECK(units_of(pendulum + late + "  m: {block: Mass, mass: 1 kg, force: late}\n", "late") == "N");
}

TEST_CASE("the section units gives units to the elements of an estimate") {
  const std::string units = "units: {kf.estimate.1: m, kf.estimate.2: rad}\n";
  CHECK(units_of(pendulum + filter, "kf") == "?, ?");
  CHECK(units_of(units + pendulum + filter, "kf") == "m, rad");
  CHECK(units_of("units: {kf.estimate.1: m}\n" + pendulum + filter, "kf") == "m, ?");
  CHECK(faults_of(units + pendulum + filter + "  m: {block: Mass, mass: 1 kg, force: kf.estimate.1}\n")
            .size() == 1);
}

TEST_CASE("the section units names units of SI, since it converts no numbers") {
  for (const auto& [unit, si] :
       {std::pair{"mm", "m"}, std::pair{"deg", "rad"}, std::pair{"degC", "K"}, std::pair{"kN", "N"}})
    CHECK(faults_of(pendulum + "  e: {block: Expression, u: [x], expression: u1}\nunits: {e: " + unit + "}\n")
              .at(0) == "test.yaml:10:12: units.e: numbers are in SI and stay as they are, so that " +
                            std::string(unit) + " would be wrong; write " + si + ", and convert numbers in " +
                            unit + " by a Gain");
}

TEST_CASE("a vector of elements in different units has no length") {
  CHECK(faults_of(pendulum + "  z: {block: Norm, u: y}\n").at(0) ==
        "test.yaml:9:23: z.u: y has elements in m and rad, and Norm takes one unit; give them one, as by a "
        "Gain for each");
  CHECK(units_of(pendulum + "  w: {block: Mux, u: [x, x]}\n  z: {block: Norm, u: w}\n", "z") == "m");
}

TEST_CASE("one limit for elements in several units is refused at the limit, not at their Mux") {
  CHECK(faults_of(pendulum + "  s: {block: Saturation, u: y, lower: -1 mm, upper: 1 mm}\n").at(0) ==
        "test.yaml:9:39: s.lower: the number is in m, but s.lower has an element in rad; write a list "
        "with a number for each element");
  CHECK(faults_of(pendulum + "  l: {block: UnitDelay, u: y, every: 1 ms, initial: 1 mm}\n")
            .at(0)
            .find("test.yaml:9:53: l.initial: the initial value is in m") == 0);
  CHECK(faults_of(pendulum + "  f: {block: Mass, mass: 1 kg, force: y.1}\n").size() == 1);
}

TEST_CASE("a list of limits without units is in SI") {
  CHECK(units_of(pendulum + "  s: {block: Saturation, u: y, lower: [-0.001, -0.02], upper: [0.001, 0.02]}\n",
                 "s") == "m, rad");
}

TEST_CASE("a signal whose block cannot know its unit has that of what it feeds") {
  const std::string root =
      "solver: rk4\nblocks:\n  hold: {block: Mass, mass: 1 kg, force: 1 N}\n  n: {block: Ramp, slope: 1 "
      "mm/s}\n"
      "  f: {block: Expression, u: n, expression: 4*u}\n";
  CHECK(units_of(root, "f") == "?");
  CHECK(units_of(root + "  m: {block: Mass, mass: 1 kg, force: f}\n", "f") == "N");
  CHECK(units_of("units: {f: Pa}\n" + root, "f") == "Pa");
  CHECK(faults_of("units: {f: Pa}\n" + root + "  m: {block: Mass, mass: 1 kg, force: f}\n").size() == 1);
}

TEST_CASE("a matrix of bare numbers takes a vector of different units") {
  const std::string feedback = pendulum + "  u: {block: MatrixGain, u: y, gain: [[1, 2]]}\n";
  CHECK(units_of(feedback, "u") == "?");
  CHECK(units_of(feedback + "  m: {block: Mass, mass: 1 kg, force: u}\n", "u") == "N");
  CHECK(units_of("units: {u: N}\n" + feedback, "u") == "N");
}

TEST_CASE("coefficients of a transfer function fall by one second from power to power") {
  const auto tank = [](const std::string& denominator) {
    return "solver: rk4\nblocks:\n  f: {block: Step, time: 1 s, after: 1 N}\n  x: {block: TransferFunction, "
           "u: f, "
           "numerator: [1], denominator: " +
           denominator + "}\n";
  };
  const std::string mass = "[2 kg, 8 N s/m, 200 N/m]";
  CHECK(units_of(tank(mass) + "  v: {block: Derivative, u: x, tau: 1 ms}\n", "v") == "?");
  CHECK(units_of("units: {x: m}\n" + tank(mass), "x") == "m");
  CHECK(faults_of(tank("[2 kg, 8 N/m, 200 N/m]")).at(0) ==
        "test.yaml:4:74: x.denominator: 8 N/m is in N/m; beside the coefficients before it, it must be in N "
        "s/m");
}

TEST_CASE("turns per time and periods per time meet on no wire") {
  const std::string wheel =
      "blocks:\n  n: {block: Constant, value: 60 rpm}\n  f: {block: Constant, value: 1 Hz}\n";
  CHECK(faults_of(wheel + "  s: {block: Sum, u: [n, f]}\n").size() == 1);
  CHECK(faults_of(wheel + "  s: {block: Sum, u: [n, 2 1/s]}\n").empty());
  CHECK(faults_of(wheel + "  turned: {block: Gain, u: f, gain: 6.283185307179586 rad}\n"
                          "  s: {block: Sum, u: [n, turned]}\n")
            .empty());
}

}  // namespace stepwire::diagram
