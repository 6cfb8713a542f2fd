#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

/// The value of a Constant that is written so, below some parameters.
std::vector<double> value_of(const std::string& text, const std::string& parameters = "{}",
                             const std::vector<Setting>& settings = {}) {
  const run::RunResult result = result_of(
      "parameters: " + parameters + "\nblocks:\n  c: {block: Constant, value: " + text + "}\nrecord: c\n",
      settings);
  std::vector<double> values;
  const auto& columns = result.recordings.at(0).table.columns;
  for (std::size_t i = 1; i < columns.size(); ++i) values.push_back(columns[i].values[0]);
  return values;
}

std::string fault_of(const std::string& parameters, const std::string& value = "1",
                     const std::vector<Setting>& settings = {}) {
  const auto refused = faults_of(
      "parameters: " + parameters + "\nblocks:\n  c: {block: Constant, value: " + value + "}\n", settings);
  REQUIRE(refused.size() == 1);
  return refused[0];
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("values are numbers with units, lists, parameters and expressions of them") {
  CHECK(value_of("5 mm") == Values{0.005});
  CHECK(value_of("[1 m, 2 mm, 3 m]") == Values{1, 0.002, 3});
  CHECK(value_of("{value: [1, 2], unit: mm}") == Values{0.001, 0.002});
  CHECK(value_of("$v", "{v: [1, 2]}") == Values{1, 2});
  CHECK(value_of("[$a, = 2*a]", "{a: 3}") == Values{3, 6});
  CHECK(value_of("= 2 kHz / a", "{a: 10 Hz}") == Values{200});
}

TEST_CASE("parameters may use each other in any order") {
  CHECK(value_of("$a", "{a: = b + c, b: = 2 * c, c: {value: 3, above: $low}, low: 1}") == Values{9});
}

TEST_CASE("an expression in quotes is one all the same") {
  CHECK(value_of("\"= a > 1 ? 10 : 20\"", "{a: 3}") == Values{10});
  CHECK(value_of("$b", "{a: 0, b: \"= max(a, a > 1 ? 10 : 20)\"}") == Values{20});
}

TEST_CASE("a text that begins with = stays a text where a text is wanted") {
  const auto refused = faults_of("blocks:\n  e: {block: Expression, expression: \"=u1\", u: 1}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("e.expression: '=u1'"));
}

TEST_CASE("a number in quotes is a text, and the message says so") {
  CHECK(fault_of("{}", "\"2\"") ==
        "test.yaml:3:31: c.value: '2' is text because of its quotes; leave them out for a number");
}

TEST_CASE("a circle of parameters is refused once, with its hops") {
  CHECK(fault_of("{a: = b, b: = c + 1, c: = 2 * a, d: = a}", "$d") ==
        "test.yaml:1:14: a: depends on itself: a -> b -> c -> a");
}

TEST_CASE("a parameter's range holds for what the file, the user and the sweep give it") {
  CHECK(fault_of("{a: {value: -1 s, above: 0}}") ==
        "test.yaml:1:25: a: -1 s is not allowed; it must be above 0");
  CHECK(fault_of("{a: {value: [1, 9], at_most: 5}}") ==
        "test.yaml:1:25: a: the list is not allowed; it must be at most 5");
  CHECK(fault_of("{a: {value: 1 s, below: 2 s}}", "$a", {{"a", "3 s"}}) ==
        "--set a=3 s: a: 3 s is not allowed; it must be below 2 s");
  CHECK(fault_of("{a: {value: 1 s, below: 2 m}}") ==
        "test.yaml:1:37: a.below: '2 m' is in m; it must be in s");
  CHECK(fault_of("{a: {value: 1 s, below: many}}") ==
        "test.yaml:1:37: a.below: 'many' is no number, and a bound is one");
}

TEST_CASE("a unit that is unknown or the wrong one is refused") {
  CHECK(fault_of("{a: {value: 1, unit: foo}}") == "test.yaml:1:34: a: 'foo' is no unit");
  CHECK_THAT(fault_of("{}", "8 Ns/m"),
             Catch::Contains("c.value: 'Ns/m' is no unit; a product of units is written N s or N.s"));
  for (const std::string text : {"1_000", "0o17", "0b11", "1:30", "1.5.2", "1 000"})
    CHECK_THAT(fault_of("{}", text),
               Catch::Contains("'" + text + "' is no number; numbers are written 1000, 0.5 or 2e-3"));
  CHECK(fault_of("{a: 1 mm}", "1", {{"a", "3 s"}}) == "--set a=3 s: a: 3 s is in s; it must be in m");
}

TEST_CASE("parameters are listed with what was assumed and what was set") {
  const plan::Plan plan = plan_text(
      "parameters: {a: {value: 2 mm, doc: length, assumed: true}, b: 3}\nblocks:\n  c: {block: Constant, "
      "value: = a * b}\n",
      {{"b", "4"}});
  const auto& parameters = plan.diagram.parameters;
  REQUIRE(parameters.size() == 2);
  CHECK((parameters[0].name == "a" && parameters[0].assumed && !parameters[0].set &&
         parameters[0].doc == "length"));
  CHECK((parameters[1].name == "b" && !parameters[1].assumed && parameters[1].set &&
         parameters[1].text == "4"));
}

TEST_CASE("a setting reaches a parameter, a key of a block, an initial value and the head") {
  CHECK(value_of("$a", "{a: 1 mm}", {{"a", "3 mm"}}) == Values{0.003});
  CHECK(value_of("1", "{}", {{"c.value", "[4, 5]"}}) == Values{4, 5});
  const plan::Plan plan =
      plan_text("solver: euler\nblocks:\n  x: {block: Integrator, u: 1}\n",
                {{"x.initial", "7"}, {"stop", "2 s"}, {"step", "0.5 s"}, {"solver", "rk4"}});
  CHECK(plan.steps == 4);
  CHECK(plan.diagram.solver == "rk4");
  CHECK(plan.diagram.blocks[0].initial.at(0).value[0] == 7.0);
}

TEST_CASE("a setting that nothing takes is refused, with the nearest name") {
  CHECK(fault_of("{mass: 1}", "1", {{"mas", "2"}}) ==
        "--set mas=2: there is no parameter 'mas'; did you mean 'mass'?");
  CHECK(fault_of("{}", "1", {{"c.valeu", "2"}}) ==
        "--set c.valeu=2: there is no parameter 'c.valeu'; did you mean 'c.value'?");
  CHECK(fault_of("{}", "1", {{"slover", "rk4"}}) ==
        "--set slover=rk4: there is no parameter 'slover'; did you mean 'solver'?");
  const std::string far = fault_of("{mass: 1}", "1", {{"nope", "3"}});
  CHECK_THAT(far, Catch::StartsWith("--set nope=3: there is no parameter 'nope'; there are: ") &&
                      Catch::Contains("mass"));
}

TEST_CASE("an expression of parameters has their unit, and adds only what has one") {
  CHECK(fault_of("{a: 1 N, b: 2 m}", "= a + b") ==
        "test.yaml:3:35: c.value: '+' joins N and m; they must have the same unit");
  CHECK(fault_of("{a: 1 N, b: 2 m, d: {value: = a / b, below: 3 N}}", "$d") ==
        "test.yaml:1:57: d.below: '3 N' is in N; it must be in N/m");
  CHECK(value_of("= a * b + 1", "{a: 2 N, b: 3 m}") == Values{7});
}

TEST_CASE("a parameter that nothing uses is refused, unless a figure, a claim or a sweep reads it") {
  CHECK(fault_of("{a: 1, b: 2}", "$a") ==
        "test.yaml:1:20: b: nothing uses this parameter; use it as $b, or take it out");
  const std::string block = "parameters: {limit: 3}\nblocks: {c: {block: Constant, value: 1}}\nrecord: c\n";
  CHECK(faults_of(block).size() == 1);
  CHECK(faults_of(block + "claims: [{that: it is low, final: c, at_most: $limit}]\n").empty());
  CHECK(faults_of(block + "figure: {plot: lines, x: time, y: c - $limit}\n").empty());
  CHECK(faults_of(block + "sweep: {limit: [1, 2]}\n").empty());
  CHECK(faults_of(block + "claims: [{that: it is low, final: c, at_most: $limits}]\n").size() == 1);
}

TEST_CASE("what is said about a parameter is text, a flag and a value, and its name no constant") {
  CHECK(fault_of("{a: {doc: length}}") ==
        "test.yaml:1:17: a: 'value' is missing (the default: a number with unit, a list, a word, = "
        "expression): {value: 2 kg, doc: of the body}");
  CHECK(fault_of("{a: {value: 1, doc: [x]}}", "$a") == "test.yaml:1:33: a.doc: a text is wanted here");
  CHECK(fault_of("{a: {value: 1, assumed: maybe}}", "$a") ==
        "test.yaml:1:37: a.assumed: 'maybe' is neither true nor false");
  for (const std::string name : {"pi", "e", "time"})
    CHECK_THAT(fault_of("{" + name + ": 3}", "$" + name),
               Catch::StartsWith("test.yaml:1:14: " + name + ": is no name for a parameter"));
}

TEST_CASE("a parameter that is drawn by a seed that is not whole is refused where it is drawn") {
  const auto refused = faults_of(
      "parameters:\n  subject: 1.5\n  reach: \"= 2*lognormal(subject, 1, 0.3)\"\nblocks:\n"
      "  y: {block: Constant, value: $reach}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0],
             Catch::StartsWith("test.yaml:3:") &&
                 Catch::Contains("'lognormal' draws by a seed that is a whole number, and 1.5 is none"));
  const auto negative = faults_of(
      "parameters: {reach: \"= lognormal(1, 0, -1)\"}\nblocks: {y: {block: Constant, value: $reach}}\n");
  REQUIRE(negative.size() == 1);
  CHECK_THAT(negative[0], Catch::Contains("'lognormal' takes a standard deviation, and -1 is below 0"));
}

TEST_CASE("a setting that is no number is refused where it is made, not where the file uses it") {
  const std::string cure = "; write one, as 2 kg, and '=' before what is computed";
  CHECK(fault_of("{mass: 1 kg}", "$mass", {{"mass", "2*3kg"}}) ==
        "--set mass=2*3kg: mass: '2*3kg' is no number" + cure);
  CHECK(fault_of("{mass: 1 kg}", "= 2*mass", {{"mass", "heavy"}}) ==
        "--set mass=heavy: mass: 'heavy' is no number" + cure);
  CHECK(fault_of("{a: 1}", "$a", {{"a", "b"}}) ==
        "--set a=b: a: 'b' is no number; write one, as 2, and '=' before what is computed");
  CHECK(value_of("$mass", "{mass: 1 kg}", {{"mass", "= 2*3 kg"}}) == Values{6});
}

TEST_CASE("an angle per time is no frequency in Hz, nor the other way round") {
  const auto fault = [](const std::string& block) {
    const auto all = faults_of("blocks:\n  b: {block: " + block + "}\n");
    return all.empty() ? std::string() : all.front();
  };
  CHECK_THAT(fault("Sine, frequency: 3 rad/s"),
             Catch::Contains("is an angle per time") && Catch::Contains("; write it in Hz"));
  CHECK_THAT(fault("Sine, frequency: 60 rpm"), Catch::Contains("is an angle per time"));
  CHECK(fault("Sine, frequency: 3 1/s").empty());
  CHECK(fault("Sine, frequency: 3 kHz").empty());
}

TEST_CASE("a bound without unit is refused beside a value in a unit other than SI") {
  const auto fault = [](const std::string& parameter) {
    const auto all =
        faults_of("parameters:\n  k: " + parameter + "\nblocks:\n  c: {block: Constant, value: $k}\n");
    return all.empty() ? std::string() : all.front();
  };
  CHECK(fault("{value: 5 mm, at_most: 10}") ==
        "test.yaml:2:29: k.at_most: 10 has no unit, but the value is in mm; write 10 mm");
  CHECK_THAT(fault("{value: 5, unit: mm, above: 1}"), Catch::Contains("write 1 mm"));
  CHECK_THAT(fault("{value: [5 mm, 6 mm], below: 7}"), Catch::Contains("write 7 mm"));
  CHECK_THAT(fault("{value: 20 degC, at_most: 30}"), Catch::Contains("write 30 degC"));
  for (const char* right : {"{value: 5 mm, at_least: 0, at_most: 1 cm}", "{value: 5 m, at_most: 10}",
                            "{value: 5, at_most: 10}", "{value: 50 %, at_most: 1}"})
    CHECK(fault(right) == "");
}

}  // namespace stepwire::diagram
