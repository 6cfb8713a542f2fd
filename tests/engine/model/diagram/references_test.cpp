#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string head =
    "solver: rk4\nblocks:\n  m: {block: Mass, force: 1 N}\n  l: {block: Lag, u: m.position}\n  end: {block: "
    "Terminator, u: l}\n";

std::string fault_of(const std::string& line) {
  const auto refused = faults_of(head + line);
  REQUIRE(refused.size() == 1);
  return refused[0];
}

}  // namespace

TEST_CASE("a block of several outputs is named with one of them") {
  CHECK(fault_of("  g: {block: Gain, u: m}\n") ==
        "test.yaml:6:23: g.u: 'm' has several outputs; say which: m.position, m.velocity");
  CHECK(fault_of("  g: {block: Gain, u: m.velocty}\n") ==
        "test.yaml:6:23: g.u: Mass has no output 'velocty'; did you mean 'velocity'? It has: position, "
        "velocity");
}

TEST_CASE("a state is recorded but not wired") {
  CHECK(fault_of("  g: {block: Gain, u: l.x}\n") ==
        "test.yaml:6:23: g.u: 'x' is a state inside of Lag, not an output; it can be recorded but not wired");
  CHECK(faults_of(head + "record: [l.x, l, l.y]\n").empty());
}

TEST_CASE("what has no output cannot be wired or recorded") {
  CHECK(fault_of("  g: {block: Gain, u: end}\n") == "test.yaml:6:23: g.u: 'end' (Terminator) has no output");
  CHECK(fault_of("record: end.y\n") == "test.yaml:6:9: record: 'end' (Terminator) has no output");
}

TEST_CASE("the nearest name is suggested") {
  CHECK(fault_of("  lagged: {block: Gain, u: 1}\n  g: {block: Gain, u: laged}\n") ==
        "test.yaml:7:23: g.u: there is no block 'laged'; did you mean 'lagged'?");
}

TEST_CASE("an input that is fed by nothing or by an empty list is refused") {
  CHECK(fault_of("  g: {block: Gain, u: }\n") ==
        "test.yaml:6:20: g.u: is fed by nothing; name a block or give a number");
  CHECK(fault_of("  g: {block: Sum, u: []}\n") ==
        "test.yaml:6:22: g.u: is an empty list; name at least one signal");
}

TEST_CASE(
    "an input of one signal takes no list of them, directly or through a part, nor a list inside of a list") {
  CHECK(fault_of("  g: {block: Gain, u: [l, 1]}\n") ==
        "test.yaml:6:23: g.u: takes one signal, not a list; join signals with a Mux");
  CHECK(fault_of("  g: {block: Sum, u: [[1, l], l]}\n") ==
        "test.yaml:6:23: g.u: takes one signal, not a list; join signals with a Mux");
  const DiagramFolder folder;
  folder.write("part.yaml", "stepwire: 1\ninputs: {u: {}}\nblocks:\n  g: {block: Gain, u: u}\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  t: {block: Clock}\n"
               "  p: {diagram: part.yaml, u: [t, t]}\n  q: {diagram: part.yaml, u: [1, 2]}\n");
  CHECK(
      folder.faults("main.yaml") ==
      std::vector<std::string>{"main.yaml:6:30: p.u: takes one signal, not a list; join signals with a Mux"});
}

TEST_CASE("an element of a vector is a signal, and so is one that is recorded") {
  CHECK(faults_of(
            "blocks:\n  v: {block: Constant, value: [1, 2]}\n  g: {block: Gain, u: v.1}\nrecord: [g, v.2]\n")
            .empty());
}

}  // namespace stepwire::diagram
