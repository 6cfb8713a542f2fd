#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A sine of 2 N about 0 in limits of -1 N and 3 N, so that the upper one is not reached.
const std::string limited_yaml =
    "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks:\n"
    "  wave: {block: Sine, amplitude: 2 N, frequency: 1 Hz}\n"
    "  limited: {block: Saturation, u: wave, lower: -1 N, upper: 3 N}\n"
    "  high: {block: Compare, u: wave, operator: greater, to: 2.5 N}\n"
    "record: [limited, high]\n";

/// A tank that is filled and emptied; nothing leads back to its third state.
const std::string chart_yaml =
    "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks:\n"
    "  wave: {block: Sine, amplitude: 1, frequency: 1 Hz}\n"
    "  tank:\n    block: StateMachine\n    u: [wave]\n    states:\n"
    "      fill: {to: {drain: \"u > 0.5\"}, output: [1]}\n"
    "      drain: {to: {fill: \"u < -0.5\", alarm: \"u > 2\"}, output: [0]}\n"
    "      alarm: {output: [2]}\n"
    "record: [tank.y]\n";

/// A lag with a claim on its end and none on its course.
const std::string judged_yaml =
    "stepwire: 1\nstep: 10 ms\nstop: 10 s\nsolver: rk4\nparameters:\n  level: 2\n  tau: 0.1 s\nblocks:\n"
    "  command: {block: Constant, value: $level}\n  other: {block: Constant, value: 5}\n"
    "  lag: {block: Lag, u: command, tau: $tau}\n"
    "record: [lag, other]\nclaims:\n  - {that: it arrives, final: lag, equals: 2, within: 1 %}\n";

}  // namespace

TEST_CASE("run --coverage names the limit that is not reached and the comparison that is never true") {
  const Scratch folder;
  folder.file("limited.yaml", limited_yaml);
  const Done done = run_program(folder, {"run", "limited.yaml", "--coverage", "--out", "out"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("limited (Saturation): u reaches the upper limit: never above") &&
                           Contains("high (Compare): u passes `to`: never above") &&
                           Contains("high (Compare): y: never another value"));
  CHECK_THAT(done.out, !Contains("lower limit"));
  const auto result = nlohmann::json::parse(content_of(folder.path("out/coverage.json")));
  CHECK(result["branches"] == 8);
  CHECK(result["covered"] == 5);
}

TEST_CASE("run --coverage names the intervals and cells of tables that no run uses") {
  const Scratch folder;
  folder.file("tables.yaml",
              "stepwire: 1\nstep: 0.1 s\nstop: 1 s\nblocks:\n"
              "  ramp: {block: Ramp, slope: 1}\n"
              "  curve: {block: LookupTable, u: ramp, points: [0, 0.45, 2, 3], values: [0, 1, 2, 3]}\n"
              "  plane: {block: LookupTable2D, row: ramp, column: 4, rows: [-2, -1, 5], columns: [3, 5, 7],\n"
              "          values: [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}\n"
              "record: [curve, plane]\n");
  const Done done = run_program(folder, {"run", "tables.yaml", "--coverage", "--out", "out"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out,
             Contains("coverage: 3 of 7 branches\n") &&
                 Contains("curve (LookupTable): the table: never u from 2 to 3\n") &&
                 Contains("plane (LookupTable2D): the table: never row from -2 to -1, column from 3 to 5"));
  CHECK_THAT(done.out, !Contains("u from 0 to 0.45") && !Contains("row from -1 to 5, column from 3 to 5"));
  const auto conditions = nlohmann::json::parse(content_of(folder.path("out/coverage.json")))["conditions"];
  CHECK(conditions[0]["branches"][0]["ticks"] == 5);  // 0, 0.1, .., 0.4 s
  CHECK(conditions[0]["branches"][1]["ticks"] == 6);
  CHECK(conditions[1]["branches"][2]["ticks"] == 11);
}

TEST_CASE("run --coverage sees both sides of located events: a ball touches the floor between ticks alone") {
  const Scratch folder;
  const std::string text = content_of(STEPWIRE_SOURCE_DIR "/diagrams/examples/108-ball.yaml");
  folder.file("ball.yaml", text);
  const Done plain = run_program(folder, {"run", "ball.yaml", "--out", "plain"});
  const Done done = run_program(folder, {"run", "ball.yaml", "--coverage", "--out", "out"});
  INFO(done.out << done.err);
  CHECK(plain.code == 0);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("coverage: 6 of 6 branches"));
  CHECK(content_of(folder.path("out/signals.csv")) == content_of(folder.path("plain/signals.csv")));
  const auto conditions = nlohmann::json::parse(content_of(folder.path("out/coverage.json")))["conditions"];
  for (const auto& condition : conditions)
    if (condition["what"] == "u passes `to`") CHECK(condition["branches"][1]["ticks"] >= 18);  // bounces
}

TEST_CASE("run --coverage names the cells of tables of several dimensions") {
  const Scratch folder;
  const std::string head = "stepwire: 1\nstep: 0.1 s\nstop: 1 s\nblocks:\n  ramp: {block: Ramp, slope: 1}\n";
  folder.file("cells.yaml", head +
                                "  cube: {block: LookupTableND, u: [ramp, 4, 1], "
                                "points: [[0, 0.45, 2], [3, 5, 7], [0, 1 + 1]],\n"
                                "         values: [[[0, 0], [0, 0], [0, 0]], [[0, 0], [0, 0], [0, 0]], "
                                "[[0, 0], [0, 0], [0, 0]]]}\nrecord: [cube]\n");
  const Done done = run_program(folder, {"run", "cells.yaml", "--coverage"});
  INFO(done.out << done.err);
  CHECK_THAT(done.out,
             Contains("coverage: 2 of 4 branches") &&
                 Contains("cube (LookupTableND): the table: never u1 from 0 to 0.45, u2 from 5 to 7, "
                          "u3 from 0 to 2") &&
                 !Contains("u2 from 3 to 5"));
}

TEST_CASE("run --coverage counts the conditions that a formula has, and elements one by one") {
  const Scratch folder;
  folder.file("formula.yaml",
              "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks:\n"
              "  wave: {block: Sine, amplitude: [1, 3], frequency: 1 Hz}\n"
              "  one: {block: Sine, amplitude: 1, frequency: 1 Hz}\n"
              "  bent: {block: Expression, u: one, expression: \"abs(u)\"}\n"
              "  limited: {block: Saturation, u: wave, upper: 2}\nrecord: [bent, limited]\n");
  const Done done = run_program(folder, {"run", "formula.yaml", "--coverage"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  // abs has one condition of two branches. The upper limits of two elements have four, of which the first
  // element does not reach its own; there are no lower limits.
  CHECK_THAT(done.out, Contains("coverage: 5 of 6 branches") && Contains("crossing 2 of 4"));
  CHECK_THAT(done.out, !Contains("Expression"));
}

TEST_CASE("run --coverage lists states and transitions of a chart") {
  const Scratch folder;
  folder.file("chart.yaml", chart_yaml);
  const Done done = run_program(folder, {"run", "chart.yaml", "--coverage"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("coverage: 4 of 6 branches") && Contains("the state: never alarm") &&
                           Contains("the transition drain to alarm: never taken"));
}

TEST_CASE("run --coverage adds the runs of a sweep, and has both states of a guard") {
  const Scratch folder;
  const std::string text =
      "stepwire: 1\nstep: 10 ms\nstop: 1 s\nparameters:\n  size: 1\nblocks:\n"
      "  wave: {block: Sine, amplitude: $size, frequency: 1 Hz}\n"
      "  limited: {block: Saturation, u: wave, upper: 2}\n"
      "  on: {block: Step, time: 0.5 s, before: 1, after: 1}\n"
      "  twice: {block: Gain, u: wave, gain: 2, enable: on}\nrecord: [limited, twice]\n";
  folder.file("one.yaml", text);
  folder.file("two.yaml", text + "sweep: {size: {values: [1, 3]}}\n");
  const Done one = run_program(folder, {"run", "one.yaml", "--coverage"});
  INFO(one.out << one.err);
  CHECK_THAT(one.out, Contains("coverage: 2 of 4 branches") && Contains("the part or block: never inactive"));
  const Done two = run_program(folder, {"run", "two.yaml", "--coverage", "--threads", "2"});
  INFO(two.out << two.err);
  CHECK_THAT(two.out, Contains("coverage: 3 of 4 branches") && !Contains("upper limit"));
}

TEST_CASE("mutate lists the time constant that no claim judges, and not the level") {
  const Scratch folder;
  folder.file("judged.yaml", judged_yaml);
  const Done done = run_program(folder, {"mutate", "judged.yaml", "--json"});
  INFO(done.out << done.err);
  CHECK(done.code == 1);
  const auto result = nlohmann::json::parse(done.out);
  for (const auto& one : result["mutations"]) {
    INFO(one.dump());
    const bool unjudged = one["what"] == "parameter tau";
    const std::string outcome = one["outcome"];
    if (unjudged) CHECK((outcome == "survives" || outcome == "refused"));  // a negative one is refused
    if (one["what"] == "parameter level") CHECK(outcome == "noticed");
    if (one["what"] == "wire lag.u") CHECK(outcome == "noticed");
  }
  CHECK(result["survived"] == 2);
  CHECK(result["refused"] == 1);
}

TEST_CASE("mutate refuses a file whose claims fail as it is, and one without claims") {
  const Scratch folder;
  folder.file("limited.yaml", limited_yaml);
  folder.file("failing.yaml", judged_yaml + "  - {that: it is above, final: lag, at_least: 3}\n");
  CHECK(run_program(folder, {"mutate", "limited.yaml"}).code == 2);
  const Done failing = run_program(folder, {"mutate", "failing.yaml"});
  CHECK(failing.code == 2);
  CHECK_THAT(failing.err, Contains("it is above"));
}

TEST_CASE("mutate changes each element of a list, a temperature by kelvins, and says what it leaves out") {
  const Scratch folder;
  folder.file("lists.yaml",
              "stepwire: 1\nstep: 10 ms\nstop: 0.1 s\n"
              "parameters: {gains: [1 mm, 0 mm], temp: 20 degC, none: 0}\nblocks:\n"
              "  g: {block: Constant, value: $gains}\n  t: {block: Constant, value: $temp}\n"
              "  n: {block: Constant, value: $none}\nrecord: [g, t, n]\n"
              "claims:\n  - {that: a temperature, final: t, equals: 20 degC}\n");
  const Done done = run_program(folder, {"mutate", "lists.yaml", "--json"});
  INFO(done.out << done.err);
  const auto result = nlohmann::json::parse(done.out);
  std::vector<std::string> found;
  for (const auto& one : result["mutations"])
    found.push_back(one["what"].get<std::string>() + " " + one["version"].get<std::string>() + " " +
                    one["outcome"].get<std::string>());
  CHECK(found ==
        std::vector<std::string>{"parameter gains.1 2 mm survives", "parameter gains.1 0.5 mm survives",
                                 "parameter gains.1 -1 mm survives", "parameter temp 40 degC noticed",
                                 "parameter temp 10 degC noticed", "parameter temp -20 degC noticed"});
  CHECK(result["left_out"] == nlohmann::json::array({"none: it is 0"}));
  CHECK_THAT(run_program(folder, {"mutate", "lists.yaml"}).out,
             Contains("  not mutated: parameter none: it is 0\n"));
}

TEST_CASE("mutate takes names in variables of a StateMachine for no wires") {
  const Scratch folder;
  folder.file("machine.yaml",
              "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks:\n  a: {block: Ramp, slope: 1}\n"
              "  b: {block: Ramp, slope: 2}\n  f:\n    block: StateMachine\n    u: [a, b]\n"
              "    variables: [a, b]\n    states: {x: {to: {y: a > 0.3}}, y: {output: 1}}\nrecord: f.y\n"
              "claims:\n  - {that: off, final: f.y, equals: 1}\n");
  const Done done = run_program(folder, {"mutate", "machine.yaml", "--json"});
  INFO(done.out << done.err);
  const auto report = nlohmann::json::parse(done.out);
  REQUIRE_FALSE(report["mutations"].empty());
  for (const auto& one : report["mutations"])
    CHECK_THAT(one["what"].get<std::string>(), Catch::StartsWith("wire f.u."));
}

TEST_CASE("mutate changes values of parts and elements of a list with a unit") {
  const Scratch folder;
  folder.file(
      "part.yaml",
      "stepwire: 1\nparameters: {k: 2 N/m, off: 1 N}\ninputs: {x: {unit: m}}\noutputs: {f: sum}\nblocks:\n"
      "  g: {block: Gain, u: x, gain: $k}\n  o: {block: Constant, value: $off}\n"
      "  sum: {block: Sum, signs: \"++\", u: [g, o]}\n");
  folder.file(
      "rig.yaml",
      "stepwire: 1\nstep: 10 ms\nstop: 0.1 s\nparameters: {ends: {value: [1, 2], unit: mm}}\nblocks:\n"
      "  x: {block: Constant, value: 1 m}\n  ends: {block: Constant, value: $ends}\n"
      "  rig: {diagram: part.yaml, x: x, k: 5 N/m}\nrecord: [rig, ends]\n"
      "claims:\n  - {that: one, final: rig, equals: 6 N}\n");
  const Done done = run_program(folder, {"mutate", "rig.yaml", "--json"});
  INFO(done.out << done.err);
  std::vector<std::string> found;
  const auto result = nlohmann::json::parse(done.out);
  for (const auto& one : result["mutations"])
    if (one["kind"] == "parameter")
      found.push_back(one["what"].get<std::string>() + " " + one["version"].get<std::string>() + " " +
                      one["outcome"].get<std::string>());
  CHECK(found ==
        std::vector<std::string>{"parameter ends.1 2 mm survives", "parameter ends.1 0.5 mm survives",
                                 "parameter ends.1 -1 mm survives", "parameter ends.2 4 mm survives",
                                 "parameter ends.2 1 mm survives", "parameter ends.2 -2 mm survives",
                                 "parameter rig.k 2*(5 N/m) noticed", "parameter rig.k 0.5*(5 N/m) noticed",
                                 "parameter rig.k -(5 N/m) noticed"});
}

TEST_CASE(
    "run --coverage has a sentence for blocks that never run, for a number that stays at 0, and for none") {
  const Scratch folder;
  const std::string head = "stepwire: 1\nstep: 0.1 s\nstop: 1 s\nblocks:\n  t: {block: Clock}\n";
  folder.file("none.yaml", head + "  b: {block: Gain, u: t, gain: 2}\nrecord: b\n");
  folder.file("idle.yaml",
              head +
                  "  off: {block: Constant, value: 0}\n  sat: {block: Saturation, u: t, lower: 0, "
                  "upper: 0.5, enable: off}\nrecord: sat\n");
  folder.file("zero.yaml",
              head + "  z: {block: Gain, u: t, gain: 0}\n  sign: {block: Sign, u: z}\nrecord: sign\n");
  CHECK_THAT(
      run_program(folder, {"run", "none.yaml", "--coverage"}).out,
      Contains("coverage: no block that changes during the run has a condition") && !Contains("0 of 0"));
  const std::string idle = run_program(folder, {"run", "idle.yaml", "--coverage"}).out;
  CHECK_THAT(idle, Contains("sat (Saturation): never computed, so none of its 4 branches") &&
                       !Contains("limit: never"));
  const std::string zero = run_program(folder, {"run", "zero.yaml", "--coverage"}).out;
  CHECK_THAT(zero, Contains("sign (Sign): u passes 0: always exactly there, never above or below") &&
                       !Contains("u passes 0: never"));
}

TEST_CASE("coverage counts what a sampled block reads at its own ticks, and limits of a sampled controller") {
  const Scratch folder;
  const std::string head =
      "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n"
      "  s: {block: Sine, amplitude: 2, frequency: 2 Hz}\n";
  for (const std::string block : {"{block: Saturation, u: s, lower: -1, upper: 1, every: 500 ms}",
                                  "{block: Compare, u: s, operator: \">\", to: 1, every: 500 ms}"}) {
    folder.file("slow.yaml", head + "  y: " + block + "\nrecord: y\n");  // s is 0 at all its ticks
    const std::string slow = run_program(folder, {"run", "slow.yaml", "--coverage"}).out;
    INFO(slow);
    CHECK_THAT(slow, Contains("coverage: 2 of 4 branches"));
  }
  folder.file("pid.yaml", head +
                              "  y: {block: DiscretePID, u: s, kp: 1, lower: -1, upper: 5, every: 1 ms}\n"
                              "record: y\n");
  const std::string pid = run_program(folder, {"run", "pid.yaml", "--coverage"}).out;
  INFO(pid);
  CHECK_THAT(pid, Contains("coverage: 3 of 4 branches") &&
                      Contains("y (DiscretePID): the output reaches the upper limit: never there"));
}

TEST_CASE("a number that is 0 is on the side that the block takes there") {
  const Scratch folder;
  const auto text_of = [&](const std::string& block) {
    folder.file("ramp.yaml",
                "stepwire: 1\nstep: 0.1 s\nstop: 1 s\nblocks:\n  t: {block: Ramp, slope: 1}\n  y: " + block +
                    "\nrecord: y\n");
    return run_program(folder, {"run", "ramp.yaml", "--coverage"}).out;
  };
  for (const std::string never :
       {"{block: Expression, u: t, expression: \"u1 >= 0 ? 1 : 2\"}",
        "{block: Compare, u: t, operator: \">=\", to: 0}", "{block: Abs, u: t}",
        "{block: Saturation, u: t, lower: 0, upper: 0.5}",
        "{block: Switch, control: t, criterion: greater_equal, then: 1, else: 2}"}) {
    INFO(never << text_of(never));
    CHECK_THAT(text_of(never), Contains("never below"));
  }
  for (const std::string both :
       {"{block: Expression, u: t, expression: \"u1 > 0 ? 1 : 2\"}",
        "{block: Compare, u: t, operator: \">\", to: 0}", "{block: Switch, control: t, then: 1, else: 2}"}) {
    INFO(both << text_of(both));
    CHECK_THAT(text_of(both), !Contains("never below"));
  }
}
