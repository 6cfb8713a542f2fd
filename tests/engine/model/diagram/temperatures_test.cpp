#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string rooms =
    "solver: euler\nblocks:\n  hold: {block: Mass, mass: 1 kg, force: 1 N}\n  room: {block: Constant, value: "
    "30 degC}\n  oven: {block: Constant, value: 200 degC}\n"
    "  gap: {block: Sum, signs: \"+-\", u: [oven, room]}\n";

std::vector<std::string> faults(const std::string& blocks) {
  return faults_of(rooms + blocks);
}

std::string fault(const std::string& blocks) {
  const auto all = faults(blocks);
  REQUIRE(all.size() == 1);
  return all[0].substr(all[0].find(": ") + 2);
}

}  // namespace

TEST_CASE("a threshold of a difference of temperatures is in kelvin") {
  CHECK(
      fault("  r: {block: Relay, u: gap, switch_on: 1 degC, switch_off: -1 K}\n") ==
      "r.switch_on: the number is a temperature, but a difference of temperatures is meant; write it in K or "
      "delta_degC");
  CHECK(faults("  r: {block: Relay, u: gap, switch_on: 1 degC, switch_off: -1 degC}\n").size() == 2);
  CHECK(faults("  r: {block: Relay, u: gap, switch_on: 1 K, switch_off: -1 K}\n").empty());
  CHECK(faults("  r: {block: Relay, u: gap, switch_on: 1 delta_degC, switch_off: -1 K}\n").empty());
  CHECK(faults("  r: {block: Relay, u: room, switch_on: 22 degC, switch_off: 20 degC}\n").empty());
  CHECK(faults("  c: {block: Compare, u: room, operator: greater, to: 22 degC}\n").empty());
  CHECK(faults("  s: {block: Saturation, u: room, lower: 0 degC, upper: 100 degC}\n").empty());
  CHECK(faults("  c: {block: Compare, u: gap, operator: greater, to: 22 degC}\n").size() == 1);
}

TEST_CASE("what only a difference can be is refused in degC") {
  CHECK(faults("  s: {block: Sine, amplitude: 1 degC, bias: 20 degC, frequency: 1 Hz}\n").size() == 1);
  CHECK(faults("  s: {block: Sine, amplitude: 1 K, bias: 20 degC, frequency: 1 Hz}\n").empty());
  CHECK(faults("  b: {block: Backlash, u: room, width: 1 degC}\n").size() == 1);
  CHECK(faults("  g: {block: Gain, u: room, gain: 2 degC}\n").size() == 1);
  CHECK(faults("  z: {block: DeadZone, u: gap, lower: -1 degC, upper: 1 degC}\n").size() == 2);
  CHECK(faults("  z: {block: DeadZone, u: room, lower: 18 degC, upper: 22 degC}\n"
               "  c: {block: Compare, u: z, operator: greater, to: 1 K}\n")
            .empty());
  CHECK(faults("  z: {block: DeadZone, u: room, lower: 18 degC, upper: 22 degC}\n"
               "  c: {block: Compare, u: z, operator: greater, to: 1 degC}\n")
            .size() == 1);
}

TEST_CASE("a sum of temperatures is a temperature where it is a mean, a difference where it subtracts") {
  const std::string warm = "  c: {block: Compare, operator: greater, to: 22 degC, u: ";
  CHECK(faults("  s: {block: Sum, u: [room, oven]}\n").size() == 1);
  CHECK(faults("  g: {block: Gain, u: room, gain: 2}\n" + warm + "g}\n").size() == 1);
  CHECK(faults("  s: {block: Sum, u: [room, oven]}\n  mean: {block: Gain, u: s, gain: 0.5}\n" + warm +
               "mean}\n")
            .empty());
  CHECK(faults("  s: {block: Sum, u: [room, oven]}\n  l: {block: Lag, u: s, tau: 1 s}\n" + warm + "l}\n")
            .size() == 1);
  CHECK(faults("  warmer: {block: Sum, u: [room, gap]}\n" + warm + "warmer}\n").empty());
}

TEST_CASE("temperatures follow the wires through blocks with a memory, and initial values") {
  CHECK(faults("  l: {block: Lag, u: gap, tau: 1 s}\n"
               "  c: {block: Compare, u: l, operator: greater, to: 1 degC}\n")
            .size() == 1);
  const std::string heated =
      "  rate: {block: Gain, u: gap, gain: 0.1 1/s}\n"
      "  t: {block: Integrator, u: rate, initial: 20 degC}\n";
  CHECK(faults_of(rooms + heated +
                  "  e: {block: Sum, signs: \"+-\", u: [room, t]}\n"
                  "  r: {block: Relay, u: e, switch_on: 1 degC, switch_off: -1 K}\n")
            .size() == 1);
}

TEST_CASE("an initial value of a scaled difference is a difference") {
  const std::string message =
      "l.initial: the initial value is a temperature, but a difference of temperatures is meant; write it in "
      "K "
      "or delta_degC";
  CHECK(fault("  l: {block: Lag, u: gap, tau: 1 s, initial: 1 degC}\n") == message);
  CHECK(faults("  l: {block: Lag, u: gap, tau: 1 s, initial: 1 K}\n").empty());
  CHECK(faults("  l: {block: Lag, u: room, tau: 1 s, initial: 1 degC}\n").empty());
  CHECK(faults("  l: {block: Lag, u: room, tau: 1 s, initial: 1 delta_degC}\n").size() == 1);
}

TEST_CASE("a product of a temperature and a number other than 1 is no temperature") {
  CHECK_THAT(fault("  p: {block: Product, u: [room, 200 %]}\n"),
             Catch::Contains("adds or scales temperatures in degC"));
  CHECK(faults("  two: {block: Constant, value: 200 %}\n  p: {block: Product, u: [room, two]}\n").size() ==
        1);
  CHECK(faults("  p: {block: Product, u: [room, 100 %]}\n").empty());
  CHECK(faults("  p: {block: Product, u: [gap, 200 %]}\n"
               "  c: {block: Compare, u: p, operator: greater, to: 1 degC}\n")
            .size() == 1);
  CHECK(faults("  s: {block: Sum, u: [room, oven]}\n  p: {block: Product, u: [s, 50 %]}\n"
               "  c: {block: Compare, u: p, operator: greater, to: 1 degC}\n")
            .empty());
}

TEST_CASE("a unit that the file gives is in SI, so that it makes no temperature of twice one") {
  const std::string twice = "  g: {block: Gain, u: room, gain: 2}\n";
  CHECK_THAT(faults(twice + "units: {g: degC}\n").at(0),
             Catch::Contains("so that degC would be wrong; write K"));
  CHECK(faults("  g: {block: Gain, u: gap, gain: 2}\nunits: {g: delta_degC}\n").empty());
  CHECK(faults(twice + "units: {g: V}\n").empty());
  CHECK(faults(twice + "  l: {block: Lag, u: g, tau: 1 s}\n").empty());
}

TEST_CASE("a multiple of a parameter in degC is no temperature") {
  const auto relay = [](const std::string& on) {
    return faults_of(
        "parameters: {tol: 1 degC, cold: -1 degC}\n" + rooms +
        "  r: {block: Relay, u: gap, switch_on: " + on +
        ", switch_off: -1 K}\n  t: {block: Constant, value: $tol}\n  d: {block: Constant, value: $cold}\n");
  };
  CHECK(relay("= 2*tol").size() == 1);
  CHECK(relay("$tol").size() == 1);
  CHECK(relay("= tol + cold").size() == 1);
  CHECK(relay("= tol - cold").empty());
}

TEST_CASE("a factor with degC in its unit takes differences of temperatures only") {
  const auto is_refused = [](const std::string& block) {
    const auto all = faults("  loss: {" + block + "}\n");
    return all.size() == 1 &&
           all[0].find("takes a difference of temperatures; subtract") != std::string::npos;
  };
  // 10 W/degC at 30 degC would be 3032 W, not 300 W.
  CHECK(fault("  loss: {block: Gain, u: room, gain: 10 W/degC}\n") ==
        "loss.u: room is a temperature, but a factor in W/delta_degC takes a difference of temperatures; "
        "subtract a reference temperature first, or write K in the factor of a temperature above absolute "
        "zero");
  for (const char* unit : {"W/degC", "W/degF", "W/delta_degC", "degC^-1.W", "W.degC-1", "J/(kg.degC)"}) {
    INFO(unit);
    const std::string gain = "block: Gain, gain: 10 " + std::string(unit) + ", u: ";
    CHECK(is_refused(gain + "room"));
    CHECK_FALSE(is_refused(gain + "gap"));
    CHECK(faults("  loss: {" + gain + "gap}\n").empty());
  }
  CHECK(faults("  loss: {block: Gain, u: room, gain: 10 W/K}\n").empty());
  CHECK(is_refused("block: Gain, u: room, gain: 10 J/degC2"));
  CHECK(is_refused("block: PID, u: room, kp: 1 V/degC, ki: 1 V/degC/s"));
  CHECK(is_refused("block: Lag, u: room, gain: 1 V/degC, tau: 1 s"));
  CHECK(is_refused("block: TransferFunction, u: room, numerator: [1 V/degC], denominator: [1 s, 1]"));
  CHECK(is_refused("block: DiscreteIntegrator, u: room, gain: 1 V/degC, every: 1 s"));
  CHECK(is_refused("block: MatrixGain, u: room, gain: [[1 V/degC]]"));
  CHECK(is_refused("block: Polynomial, u: room, coefficients: [1 V/degC, 0 V/degC]"));
  CHECK(is_refused("block: Product, u: [room, 10 W/degC]"));
  CHECK(is_refused("block: Divide, numerator: room, denominator: 2 degC/W"));
  CHECK(is_refused("block: Gain, u: 30 degC, gain: 10 W/degC"));
}

TEST_CASE("a factor with degC in its unit keeps its meaning along wires, in parameters and in formulas") {
  const std::string conductance = "  k: {block: Constant, value: 10 W/degC}\n";
  CHECK(faults(conductance + "  loss: {block: Product, u: [room, k]}\n").size() == 1);
  CHECK(faults(conductance + "  loss: {block: Product, u: [gap, k]}\n").empty());
  CHECK(faults(conductance + "  late: {block: Lag, u: k, tau: 1 s}\n"
                             "  loss: {block: Product, u: [room, late]}\n")
            .size() == 1);
  const auto gain = [&](const std::string& text) {
    return faults_of("parameters: {k: 10 W/degC}\n" + rooms + "  hot: {block: Gain, u: room, gain: " + text +
                     "}\n")
        .size();
  };
  CHECK(gain("$k") == 1);
  CHECK(gain("= 2*k") == 1);
  CHECK(gain("= k/3") == 1);
  const auto formula = [&](const std::string& text) {
    return faults_of("parameters: {k: 10 W/degC}\n" + rooms + conductance +
                     "  hot: {block: Gain, u: room, gain: $k}\n" +
                     "  e: {block: Expression, u: [room, k], expression: \"" + text + "\"}\n")
               .size() -
           1;
  };
  CHECK(formula("u1*(10 W/degC)") == 1);
  CHECK(formula("u1*u2") == 1);
  CHECK(formula("u2*2*u1") == 1);
  CHECK(formula("1 + (2 1/degC)*u1") == 1);
  CHECK(formula("u1/(2 degC/W)") == 1);
  CHECK(formula("(u1 - 20 degC)*u2") == 0);
  CHECK(formula("u1*(10 W/K)") == 0);
  CHECK(formula("u2*u2") == 0);
}

TEST_CASE("a product of a factor in degC/V is a difference of temperatures") {
  const std::string sensor =
      "  volts: {block: Constant, value: 0.25 V}\n  shown: {block: Gain, u: volts, gain: 100 degC/V}\n";
  CHECK(faults(sensor + "  c: {block: Compare, u: shown, operator: greater, to: 22 degC}\n").size() == 1);
  CHECK(faults(sensor + "units: {shown: degC}\n").size() == 1);
  CHECK(faults(sensor + "units: {shown: K}\n").empty());
  CHECK(faults(sensor + "  t: {block: Sum, u: [shown, 0 degC]}\n"
                        "  c: {block: Compare, u: t, operator: greater, to: 22 degC}\n")
            .empty());
  // A rate limit and the integral of a rate take no product.
  CHECK(faults("  r: {block: RateLimiter, u: room, rising: 1 degC/s, falling: -1 degC/s}\n"
               "  i: {block: Integrator, u: 0.1 degC/s, initial: 20 degC}\n"
               "  c: {block: Compare, u: i, operator: greater, to: 22 degC}\n")
            .empty());
}

TEST_CASE("conditions hold a difference against a difference") {
  CHECK(faults_of("stop_when: gap > 10 degC\n" + rooms).size() == 1);
  CHECK(faults_of("stop_when: gap > 10 K\n" + rooms).empty());
  CHECK(faults_of("stop_when: room > 40 degC\n" + rooms).empty());
  CHECK(faults_of("stop_when: oven - room > 10 degC\n" + rooms).size() == 1);
}

}  // namespace stepwire::diagram
