#include <catch2/catch.hpp>

#include "blocks/logic/state_machine.hpp"
#include "engine/model/block/declare.hpp"
#include "tests/support/literal_text.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

using Values = std::vector<double>;

const std::string head =
    "step: 1\nstop: 9\nblocks:\n  t: {block: Clock}\n  x: {block: Gain, gain: 1 mm/s, u: t}\n";

std::string refusal(const std::string& keys, const std::string& inputs = "[x, t]") {
  return error_of(head + "  m:\n    block: StateMachine\n    u: " + inputs + "\n" + keys);
}

}  // namespace

TEST_CASE("A guard reads inputs with units, the time in its state, and stands in the order of the file") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: [x, t]
    initial: idle
    states:
      done: {output: [0, -1]}
      idle: {to: {push: "u1 >= 2 mm"}}
      push: {output: [1, 5 mm], to: {hold: "after >= 3 s", done: "after >= 3 s"}}
      hold: {output: [2, 0], to: {done: "u2 >= 7", push: "u2 > 100"}}
record: [m.state, m.y]
)");
  CHECK(column(table, "m.state") == Values{1, 1, 2, 2, 2, 3, 3, 0, 0, 0});
  CHECK(column(table, "m.y.1") == Values{0, 0, 1, 1, 1, 2, 2, 0, 0, 0});
  CHECK(column(table, "m.y.2") == Values{0, 0, 5e-3, 5e-3, 5e-3, 0, 0, -1, -1, -1});
}

TEST_CASE("A machine without inputs and outputs counts the time in its states") {
  const table::Table table = run_text(R"(
step: 1
stop: 9
blocks:
  m: {block: StateMachine, states: {red: {to: {green: "after >= 3"}}, green: {to: {red: "after >= 2"}}}}
record: [m.state, m.y]
)");
  CHECK(column(table, "m.state") == Values{0, 0, 0, 1, 1, 0, 0, 0, 1, 1});
  CHECK(column(table, "m.y") == Values(10, 0.0));
}

TEST_CASE("One input is also called u, and a slower machine acts at its own ticks") {
  const table::Table table = run_text(R"(
step: 1
stop: 9
blocks:
  t: {block: Clock}
  m: {block: StateMachine, u: t, every: 3, states: {low: {output: 4, to: {high: "u > 3.5"}}, high: {output: 7}}}
record: [m.y]
)");
  CHECK(column(table, "m.y") == Values{4, 4, 4, 4, 4, 4, 7, 7, 7, 7});
}

TEST_CASE("What is wrong with a state machine is said at its place") {
  CHECK_THAT(refusal("    states: {a: {to: {b: u1 > 1}}, c: {}}\n"),
             Catch::Contains("leads to 'b', which is none"));
  CHECK_THAT(refusal("    states: {a: {to: {b: u1 > 1}}, b: {}, c: {}}\n"),
             Catch::Contains("no transition leads to state 'c' from 'a'"));
  CHECK_THAT(refusal("    states: {a: {to: {b: u3 > 1}}, b: {}}\n"),
             Catch::Contains("u3") && Catch::Contains("u1 to u2"));
  CHECK_THAT(refusal("    states: {a: {to: {b: u1 >}}, b: {}}\n"),
             Catch::Contains("the guard from 'a' to 'b'"));
  CHECK_THAT(refusal("    states: {a: {too: {b: u1 > 1}}, b: {}}\n"), Catch::Contains("has no 'too'"));
  CHECK_THAT(refusal("    states: {a: {output: [1, 2], to: {b: u1 > 1}}, b: {output: [1]}}\n"),
             Catch::Contains("state 'b' has 1 output and one before has 2"));
  CHECK_THAT(refusal("    states: {a: {output: fast}}\n"),
             Catch::Contains("'fast' in the output of state 'a'"));
  CHECK_THAT(refusal("    initial: z\n    states: {a: {}}\n"),
             Catch::Contains("m.initial") && Catch::Contains("'z'"));
  CHECK_THAT(refusal("    states: {}\n"), Catch::Contains("must be a map of states"));
  const std::string placed = refusal("    states:\n      a:\n        to:\n          b: u1 > 1\n");
  CHECK_THAT(placed, Catch::Contains(":14:14: m.states"));
}

TEST_CASE("A machine has at most 64 inputs") {
  std::string list = "t";
  for (int i = 1; i < 64; ++i) list += ", t";
  const std::string states = "    states: {a: {to: {b: u64 > 1}}, b: {}}\n";
  CHECK(refusal(states, "[" + list + "]").empty());
  CHECK_THAT(refusal(states, "[" + list + ", t]"), Catch::Contains("m.states: 65 inputs are more than 64"));
}

TEST_CASE("Transitions and outputs of a machine read as C++") {
  const auto text = [](const char* of) { return Value{std::string(of)}; };
  const Value idle{
      Value::Map{{"output", text("5 mm")},
                 {"to", {Value::Map{{"push", text("u2 > 1")}, {"hold", text("after >= 2 s")}}}}}};
  Declare<StateMachine> declaration;
  StateMachine::declare(declaration);
  const BlockType type = declaration.take();
  StateMachine machine;
  machine.states = Tree({Value::Map{{"push", {Value::Map{{"to", {Value::Map{{"idle", text("u1 * u2")}}}}}}},
                                    {"idle", idle},
                                    {"hold", text("")}}});
  machine.initial = "idle";
  Configure is({}, 0.0, {{"u", 2}});
  machine.configure(is);
  CHECK(literal_text(type, &machine, "first") == "1");
  CHECK(literal_text(type, &machine, "values") == "Numbers::view({0, 0.005, 0}, 3)");
  CHECK(literal_text(type, &machine, "target") == "Numbers::view({1, 0, 2}, 3)");
  CHECK(literal_text(type, &machine, "guard") ==
        "Function([](const double* v) -> double { return "
        "v[3] == 0.0 ? double(v[0] * v[1]) : v[3] == 1.0 ? double(v[1] > 1.0) : double(v[2] >= 2.0); })");
}
