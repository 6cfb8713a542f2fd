// Units in formulas of blocks: Expression and StateMachine.
#include "engine/model/diagram/formula_units.hpp"

#include <catch2/catch.hpp>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/measure.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

using Catch::Contains;

namespace {

using Lines = std::vector<std::string>;

const std::string sources =
    "solver: rk4\nparameters: {limit: 40 mm, warm: 20 degC, rate: {value: 3 N s/m}}\nblocks:\n"
    "  way: {block: Ramp, slope: 1 m/s}\n  heat: {block: Constant, value: 30 degC}\n"
    "  bare: {block: Constant, value: 5}\n  speed: {block: Constant, value: 2 m/s}\n"
    "  force: {block: Constant, value: 6 N}\n";
// Each parameter is used, so that the formula alone is at fault.
const std::string uses =
    "  use: {block: Constant, value: $limit}\n  two: {block: Constant, value: $warm}\n"
    "  three: {block: Constant, value: $rate}\n";
const std::string record = "record: [y, use, two, three]\n";

Lines faults_of_expression(const std::string& keys) {
  return faults_of(sources + uses + "  y: {block: Expression, " + keys + "}\n" + record);
}

Lines faults_of_machine(const std::string& keys) {
  return faults_of(sources + uses + "  y: {block: StateMachine, " + keys +
                   "}\nrecord: [y.state, use, two, three]\n");
}

}  // namespace

TEST_CASE("a formula that joins different units is refused with its place and the units of its signals") {
  CHECK(
      faults_of_expression("u: [way, heat], variables: [x, T], expression: x + T") ==
      Lines{"test.yaml:12:73: y.expression: 'x + T', character 3: '+' joins m and K, where x (way) is in m, "
            "T (heat) is in K; they must have the same unit: give a number its unit, or divide a value by "
            "one, as u1/(1 m)"});
  for (const std::string formula :
       {"u1 > u2 ? 1 : 0", "max(u1, u2)", "sin(u1)", "u1 + 3 s", "u1 > $warm", "u1 - warm", "u2 > limit",
        "u2 - 20 mm", "u1 == $rate", "u1 > 3 N/m", "u1 + 2 N m"})
    CHECK(faults_of_expression("u: [way, heat], expression: '" + formula + "'").size() == 1);
}

TEST_CASE("formulas whose units fit are accepted, and those of signals without units") {
  for (const std::string formula :
       {"u1 + 0.5", "u1 > limit", "u1 > 40 mm && u2 > 293.15 K", "u2 > warm", "u1/(1 m) + u2/(1 K)",
        "u1*u2 + 3", "2*u1 + 3*u2", "u3 + u1 + u2*0", "u1*rate/(1 s) + 4 N", "u4*$rate - u5",
        "sqrt(u1^2 + limit^2) - u1", "hypot(u1, limit)", "u1/(1 m) > 3 && u5 < 4 N && u4*(2 N s/m) > 3 N",
        "u3 > limit ? u1 : 0"})
    CHECK(faults_of_expression("u: [way, heat, bare, speed, force], expression: '" + formula + "'") ==
          Lines{});
}

TEST_CASE("a formula that adds temperatures is refused, their mean is not") {
  const Lines sum = faults_of_expression("u: [heat, heat], expression: u1 + u2");
  REQUIRE(sum.size() == 1);
  CHECK_THAT(sum[0],
             Contains("the value adds or scales temperatures in degC") && Contains("take their mean"));
  CHECK(faults_of_expression("u: [heat, heat], expression: (u1 + u2)/2").empty());
  CHECK(faults_of_expression("u: [heat, heat], expression: u1 - u2").empty());
  CHECK(faults_of_expression("u: [way, force], expression: \"u1 > 1 ? u1 : u2\"").size() == 1);
}

TEST_CASE("guards, settings and conditions of a chart have the units of its inputs") {
  const std::string chart = "u: [way, heat], variables: [x, T], states: ";
  for (const std::string states :
       {"{a: {to: {b: x > T}}, b: {}}", "{a: {to: {b: x > 3 K}}, b: {}}",
        "{a: {to: {b: x > limit + warm}}, b: {}}", "{a: {to: {b: x > after}}, b: {}}",
        "{a: {to: [{to: b, when: T > limit}]}, b: {}}"}) {
    const Lines found = faults_of_machine(chart + states);
    REQUIRE(found.size() == 1);
    CHECK_THAT(found.front(), Contains("y.states: ") && Contains("must have the same unit"));
  }
  for (const std::string states :
       {"{a: {to: {b: x > limit && after > 3 s}}, b: {}}", "{a: {to: {b: x > 0.3 || T > warm}}, b: {}}",
        "{a: {timeout: {b: 3 s}}, b: {}}"})
    CHECK(faults_of_machine(chart + states) == Lines{});
  CHECK(faults_of_machine("u: [bare, bare], states: {a: {to: {b: u1 > u2 + 3 mm}}, b: {}}") == Lines{});
}

TEST_CASE("a number in a formula keeps its bits and its unit, whatever names the inputs have") {
  for (const std::string unit : {"m", "N", "N s/m", "1/s", "kg m^2/s^3", "rad/s", "A/m", "K", "1", "W/(m K)"})
    for (const double value : {0.04, -3.7, 1e-30}) {
      const unit::Dimension dimension = unit::parse_unit(unit)->dimension;
      const std::string text = quantity_in_formula(value, dimension);
      INFO(unit + ": " + text);
      const auto known = [](std::string_view name) { return name.size() < 4; };  // m, s and N are signals
      const expression::Expression formula(text, known);
      CHECK(formula.variables().empty());
      CHECK(formula({}) == value);
      const expression::Measure measure = formula.measure({});
      if (unit == "1") continue;
      CHECK(measure.sure);
      CHECK(measure.dimension == dimension);
    }
}

TEST_CASE("a text that is a formula of signals names parameters") {
  const std::string text =
      "step: 1 s\nstop: 3 s\nparameters: {slope: 2, base: 3, law: $slope*u1 + $base, other: '$slope*u1 - "
      "$base'}\n"
      "blocks:\n  t: {block: Clock}\n  y: {block: Expression, expression: $law, u: [t]}\n"
      "  z: {block: Expression, expression: $other, u: [t]}\nrecord: [y, z]\n";
  const table::Table run = run_text(text);
  CHECK(column(run, "y").back() == 9.0);
  CHECK(column(run, "z").back() == 3.0);
  CHECK(column(result_of(text, {{"slope", "1"}}).recordings.front().table, "y").back() == 6.0);
  CHECK(faults_of("parameters: {a: 2, b: $a*3}\nblocks:\n  y: {block: Constant, value: $b}\nrecord: y\n")
            .size() > 0);
}

}  // namespace stepwire::diagram
