// Names that a file gives: to blocks as if they lay in parts, to what it records, and units to its
// signals.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

using Lines = std::vector<std::string>;

const std::string cart =
    "solver: rk4\nblocks:\n  rig.cart: {block: Mass, force: rig.push}\n  rig.push: {block: Constant, value: "
    "2 N}\n";

}  // namespace

TEST_CASE("a block may be called as if it lay in a part, and is wired, recorded and set by that name") {
  const run::RunResult result = result_of(cart +
                                              "  fast: {block: Gain, u: rig.cart.velocity, gain: 2}\nrecord: "
                                              "[rig.cart.position, fast, rig.push]\n",
                                          {{"rig.cart.mass", "4 kg"}});
  const table::Table& table = result.recordings.at(0).table;
  CHECK(column(table, "rig.push").back() == 2.0);
  CHECK(column(table, "rig.cart.position").back() == Approx(0.5 * 2.0 / 4.0 * 9.0));
  CHECK(column(table, "fast").back() == Approx(3.0));
}

TEST_CASE("a name that could as well be the signal of another block is refused") {
  CHECK(faults_of(cart + "  rig.cart.velocity: {block: Constant}\n") ==
        Lines{"test.yaml:5:3: rig.cart.velocity: and 'rig.cart' cannot stand side by side: one would be a "
              "signal of the other"});
  CHECK(faults_of(cart + "  rig: {block: Constant}\n") ==
        Lines{"test.yaml:5:3: rig: and 'rig.cart' cannot stand side by side: one would be a signal of the "
              "other"});
  CHECK(faults_of("inputs: {u: {default: 1}}\nblocks:\n  u.a: {block: Gain, u: u}\n") ==
        Lines{"test.yaml:3:3: u.a: and 'u' cannot stand side by side: one would be a signal of the other"});
  for (const std::string name : {"rig.", ".rig", "a..b", "a.1"})
    CHECK(faults_of("blocks:\n  " + name + ": {block: Constant}\n").size() == 1);
}

TEST_CASE("the nearest of dotted names is suggested") {
  CHECK(faults_of(cart + "record: rig.crt.position\n") ==
        Lines{"test.yaml:5:9: record: there is no block 'rig.crt'; did you mean 'rig.cart'?"});
  CHECK(faults_of(cart + "record: rig.puhs\n") ==
        Lines{"test.yaml:5:9: record: there is no block 'rig.puhs'; did you mean 'rig.push'?"});
  CHECK(faults_of(cart + "record: rig.cart.x\n").size() == 1);
}

TEST_CASE("what is recorded may have a name of the file's own") {
  const run::RunResult result = result_of(
      cart +
      "record: [rig.push, {signals: [rig.cart.velocity, {v: rig.cart.velocity, rig.x: rig.cart.position}]},\n"
      "         {every: 1.5 s, signals: {x: rig.cart.position}}]\nstep: 0.5 s\n");
  REQUIRE(result.recordings.size() == 2);
  Lines names;
  for (const table::Column& column : result.recordings[0].table.columns)
    names.push_back(column.name + " " + column.unit);
  CHECK(names == Lines{"time s", "rig.push N", "rig.cart.velocity m/s", "v m/s", "rig.x m"});
  CHECK(column(result.recordings[0].table, "v") == column(result.recordings[0].table, "rig.cart.velocity"));
  CHECK(column(result.recordings[1].table, "x").size() == 3);
}

TEST_CASE("a name for what is recorded must be a name, and of one signal") {
  const auto fault = [](const std::string& signals) {
    const auto lines = faults_of(cart + "record: {signals: " + signals + "}\n");
    REQUIRE(lines.size() == 1);
    return lines[0];
  };
  CHECK_THAT(fault("{1.v: rig.push}"),
             Catch::StartsWith("test.yaml:5:20: record: '1.v' is no name for a signal"));
  CHECK_THAT(fault("[rig.push, {time: rig.push}]"), Catch::Contains("'time' is no name for a signal"));
  CHECK_THAT(fault("{v: [rig.push]}"), Catch::Contains("a name is given to one signal"));
  CHECK_THAT(fault("[rig.push, {rig.push: rig.cart.velocity}]"),
             Catch::StartsWith("test.yaml:5:41: record: two signals are named 'rig.push' here"));
  CHECK(faults_of(cart + "record: [rig.push, {signals: {rig.push: rig.push}}]\n").empty());
}

TEST_CASE("what is recorded may be named as an element is, and is no element of another signal") {
  const std::string vector =
      "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  v: {block: Constant, value: [2, 3]}\n";
  const auto names = [&](const std::string& record) {
    const run::RunResult result = result_of(vector + record);
    Lines names;
    for (const table::Column& column : result.recordings[0].table.columns) names.push_back(column.name);
    return names;
  };
  CHECK(names("record: {signals: {x.2: v.2}}\n") == Lines{"time", "x.2"});
  CHECK(names("record: {signals: {x: v, x.2: v.2}}\n") == Lines{"time", "x.1", "x.2"});
  const auto faults = faults_of(vector + "record: {signals: {x: v, x.2: v.1}}\n");
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::Contains("'x.2' is the name of an element of 'x', recorded here as well"));
}

TEST_CASE("a file may say the unit of a signal, which then holds along its wires") {
  const std::string blocks =
      "blocks:\n  a: {block: Constant, value: 2}\n  b: {block: Gain, u: a, gain: 3 m}\nrecord: b\n";
  CHECK(result_of(blocks).recordings.at(0).table.columns.at(1).unit.empty());
  CHECK(result_of(blocks + "units: {a: N}\n").recordings.at(0).table.columns.at(1).unit == "N m");
  CHECK(faults_of("units: {a: N}\nblocks: {a: {block: Constant, value: 2 s}}\n") ==
        Lines{"test.yaml:1:12: units.a: a is in s, but units.a is in N; connect a signal in N, or put a Gain "
              "in N/s between them"});
  CHECK(faults_of(blocks + "units: {c: N, a: 5}\n") ==
        Lines{"test.yaml:5:9: units.c: there is no block 'c'", "test.yaml:5:18: units.a: '5' is no unit"});
  CHECK(faults_of(blocks + "units: N\n") == Lines{"test.yaml:5:8: units: must be a map of signal: unit"});
}

}  // namespace stepwire::diagram
