// Formulas without their '=' at places that take only a formula.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

double value(const std::string& parameters, const std::string& blocks, const std::string& signal) {
  const auto result =
      result_of("parameters:\n" + parameters + "blocks:\n" + blocks + "record: [" + signal + "]\n");
  return column(result.recordings[0].table, signal).back();
}

}  // namespace

TEST_CASE("in a matrix, in a list with a number and in a bound only formulas can stand, in whatever order") {
  CHECK(value("  b: [0, 2*a]\n  a: 3\n", "  v: {block: Constant, value: $b}\n  g: {block: Gain, u: v.2}\n",
              "g") == 6.0);
  CHECK(value("  a: 3\n  b: {value: = a + 1, above: a}\n", "  g: {block: Constant, value: $b}\n", "g") ==
        4.0);
}

TEST_CASE("a definition without '=' is a text, which may be the formula of a block with names of its own") {
  // y is the second input of the block, not the parameter.
  CHECK(value("  y: 190\n  right: 8*(1 - y/20)\n",
              "  one: {block: Constant, value: 10}\n  v: {block: Constant, value: $y}\n"
              "  g: {block: Expression, u: [one], variables: [y], expression: \"$right\"}\n",
              "g") == 4.0);
}

TEST_CASE("the text of a parameter that would be a formula is refused with the '=' that it lacks") {
  CHECK_THAT(faults_of("parameters: {m: 4, two: 2*m}\nblocks:\n  g: {block: Constant, value: $two}\n")[0],
             Catch::Contains("g.value: '2*m' is a text there; a formula of parameters is written '= 2*m'"));
}

TEST_CASE("a formula in which a name stands for nothing is refused by that name") {
  CHECK_THAT(faults_of("parameters: {speed: 4}\nblocks:\n  g: {block: Constant, value: 2*spede}\n")[0],
             Catch::Contains("g.value: there is no parameter 'spede'; did you mean 'speed'?"));
}

TEST_CASE("a number of a block is a parameter by its name, or a formula of some") {
  CHECK(value("  k: 4\n", "  one: {block: Constant, value: 1}\n  g: {block: Gain, u: one, gain: k}\n", "g") ==
        4.0);
  CHECK(value("  k: 4\n", "  one: {block: Constant, value: 1}\n  g: {block: Gain, u: one, gain: \"-k/2\"}\n",
              "g") == -2.0);
  CHECK(value("  k: 4\n", "  g: {block: Constant, value: [k, 2*k]}\n  h: {block: Gain, u: g.2}\n", "h") ==
        8.0);
}

TEST_CASE("a word stays a word, though a parameter has its name") {
  const plan::Plan plan = plan_text(
      "parameters: {less: 1, op: less}\nblocks: {a: {block: Constant, value: $less}, c: {block: Compare, u: "
      "a,"
      " to: 2, operator: $op}}\nrecord: [c]\n");
  CHECK(plan.diagram.parameters[1].text == "less");
}

TEST_CASE("an Expression knows parameters by their names, but for its own") {
  CHECK(value("  k: 4\n  x: 100\n",
              "  one: {block: Constant, value: 1}\n"
              "  g: {block: Expression, u: [one, $x], variables: [x, y], expression: \"k*x + y\"}\n",
              "g") == 104.0);
}

TEST_CASE("a run may stop at a parameter by its name") {
  const auto result = result_of(
      "parameters: {until: 1 s}\nblocks: {a: {block: Constant, value: 1}}\nrecord: [a]\nstop_when: time >= "
      "until\n");
  CHECK(column(result.recordings[0].table, "time").back() == 1.0);
}

TEST_CASE("units stand one behind the other in formulas, too") {
  CHECK(value("  c: = 0.4 N s/m + 1 N s/m\n  d: = 2*c\n", "  g: {block: Constant, value: d}\n", "g") ==
        Approx(2.8));
}

TEST_CASE("a parameter is recorded as what it is in the run") {
  const auto result = result_of(
      "parameters: {m: 2 kg, twice: = m + m, R: \"= [[m/1 kg, 2], [3, 4]]\"}\n"
      "blocks: {a: {block: Constant, value: 1}}\nrecord: [a, $twice, $R, {signals: {mass: $m}}]\n",
      {{"m", "3 kg"}});
  const table::Table& table = result.recordings[0].table;
  CHECK(column(table, "twice").back() == 6.0);
  CHECK(column(table, "mass").back() == 3.0);
  CHECK(column(table, "R.2.1").back() == 3.0);
  CHECK(table.find("twice")->unit == "kg");
}

}  // namespace stepwire::diagram
