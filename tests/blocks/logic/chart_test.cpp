// States in states, counters, priorities and time-outs of a StateMachine.
#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

using Values = std::vector<double>;

const std::string head = "step: 1\nstop: 11\nblocks:\n  t: {block: Clock}\n";

std::string refusal(const std::string& keys) {
  return error_of(head + "  m:\n    block: StateMachine\n    u: t\n" + keys);
}

}  // namespace

TEST_CASE("Inputs have names, and a time-out leads on where no guard does") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: t
    variables: [now]
    states:
      a: {to: {c: now >= 9 && now < 10}, timeout: {b: 3 s}}
      b: {to: {a: "after >= 2"}}
      c: {output: 5}
record: [m.state, m.y]
)");
  CHECK(column(table, "m.state") == Values{0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0});
}

TEST_CASE("A state holds others: its transitions come first, its output is theirs, its time is its own") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: t
    states:
      on:
        output: 7
        to: {off: after >= 5}
        initial: two
        states:
          one: {to: {two: after >= 1}}
          two: {output: 8, to: {one: after >= 2}}
      off: {to: {on.one: after >= 3}}
record: [m.state, m.y]
)");
  // 0 on, 1 on.one, 2 on.two, 3 off
  CHECK(column(table, "m.state") == Values{2, 2, 1, 2, 2, 3, 3, 3, 1, 2, 2, 1});
  CHECK(column(table, "m.y") == Values{8, 8, 7, 8, 8, 0, 0, 0, 7, 8, 8, 7});
}

TEST_CASE("A state with history goes on where it was left, one without begins anew") {
  for (const bool history : {true, false}) {
    const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: t
    states:
      on:
        history: )" + (history ? "true" : "false") +
                                        R"(
        to: {off: u >= 4 && u < 5}
        states: {one: {to: {two: after >= 2}}, two: {to: {one: after >= 100}}}
      off: {to: {on: after >= 2}}
record: [m.state]
)");
    CHECK(column(table, "m.state") == (history ? Values{1, 1, 2, 2, 3, 3, 2, 2, 2, 2, 2, 2}
                                               : Values{1, 1, 2, 2, 3, 3, 1, 1, 2, 2, 2, 2}));
  }
}

TEST_CASE(
    "Counters are set when states are entered, left and kept, and by transitions, one after the other") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: t
    counters: {entered: 0, left: 10, kept: 0, both: 0}
    states:
      a: {enter: {entered: entered + 1, both: 2 * entered}, exit: {left: left - 1}, each: {kept: kept + u},
          to: [{to: b, when: after >= 3, set: {both: both + 100}}]}
      b: {to: {a: entered < 2 && after >= 2}}
record: [m.state, m.counts]
)");
  CHECK(column(table, "m.state") == Values{0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1});
  CHECK(column(table, "m.counts.1") == Values{1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2});
  CHECK(column(table, "m.counts.2") == Values{10, 10, 10, 9, 9, 9, 9, 9, 8, 8, 8, 8});
  // Kept at 0, 1, 2 and at 6, 7: not at the ticks of a transition.
  CHECK(column(table, "m.counts.3") == Values{0, 1, 3, 3, 3, 3, 9, 16, 16, 16, 16, 16});
  CHECK(column(table, "m.counts.4") == Values{2, 2, 2, 102, 102, 4, 4, 4, 104, 104, 104, 104});
}

TEST_CASE("Transitions with a priority are tried in its order, before those without") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    u: t
    states:
      a: {to: [{to: b, when: u > 0}, {to: c, when: u > 0, priority: 2}, {to: d, when: u > 0, priority: 1}]}
      b:
      c:
      d:
record: [m.state]
)");
  CHECK(column(table, "m.state")[1] == 3.0);
}

TEST_CASE("Parameters have bare names wherever a chart has a formula") {
  const table::Table table = run_text("parameters: {limit: 4, hold: 2, more: 10, b: 99, n: 99}\n" + head +
                                      R"(  of_n: {block: Constant, value: [n, b]}
  m:
    block: StateMachine
    u: t
    counters: {n: 0}
    states:
      a: {to: {b: u >= limit}, exit: {n: n + more}}
      b: {timeout: {c: hold}, each: {n: n + more/10}}
      c: {to: [{to: b, when: u > 2*limit, set: {n: n + limit}}]}
record: [m.state, m.counts]
)");
  CHECK(column(table, "m.state") == Values{0, 0, 0, 0, 1, 1, 2, 2, 2, 1, 1, 2});
  CHECK(column(table, "m.counts") == Values{0, 0, 0, 0, 10, 11, 11, 11, 11, 15, 16, 16});
}

TEST_CASE("A state that leads to itself is left and entered") {
  const table::Table table = run_text(head + R"(  m:
    block: StateMachine
    counters: {n: 0}
    states: {a: {enter: {n: n + 1}, to: {a: after >= 3}}}
record: [m.counts]
)");
  CHECK(column(table, "m.counts") == Values{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4});
}

TEST_CASE("What is wrong with a chart is said at its place") {
  CHECK_THAT(refusal("    states: {a: {enter: {n: 1}}}\n"), Catch::Contains("'n', which is no counter"));
  CHECK_THAT(refusal("    states: {a: {history: true}}\n"), Catch::Contains("holds no states"));
  CHECK_THAT(refusal("    states: {a: {initial: z, states: {b: }}}\n"),
             Catch::Contains("holds no state 'z'"));
  CHECK_THAT(refusal("    counters: {n: x}\n    states: {a: }\n"), Catch::Contains("needs a number"));
  CHECK_THAT(refusal("    variables: [x, y]\n    states: {a: }\n"), Catch::Contains("2 names for 1 input"));
  CHECK_THAT(refusal("    states: {a: {to: [{when: u > 1}]}}\n"), Catch::Contains("must be a map such as"));
  CHECK_THAT(refusal("    states: {a: {to: [{to: a, when: u > 1, rank: 1}]}}\n"),
             Catch::Contains("has no 'rank'"));
  CHECK_THAT(refusal("    states: {a: {timeout: {b: 3 mm}}, b: {}}\n"),
             Catch::Contains("from 'a' to 'b'") && Catch::Contains("mm"));
  CHECK_THAT(refusal("    states: {a: {to: {b: after > 3 mm}}, b: {}}\n"), Catch::Contains("'after > 3 mm'"));
  CHECK_THAT(refusal("    states: {a: {timeout: {b: 3 s}}}\n"),
             Catch::Contains("leads to 'b', which is none"));
}

TEST_CASE("A misspelt state or key of a chart is refused with the nearest one") {
  CHECK_THAT(refusal("    states: {off: {to: {onn: u > 1}}, on: }\n"),
             Catch::Contains("leads to 'onn', which is none; did you mean 'on'? The states are: off, on"));
  CHECK_THAT(refusal("    states: {a: {outptu: 1}}\n"),
             Catch::Contains("has no 'outptu'; did you mean 'output'? It has: output, to,"));
  CHECK_THAT(refusal("    states: {a: {to: [{to: a, whne: u > 1, when: u > 1}]}}\n"),
             Catch::Contains("has no 'whne'; did you mean 'when'?"));
  CHECK_THAT(refusal("    states: {a: {to: {b: 'sinh2(u) > 1'}}, b: }\n"),
             Catch::Contains("did you mean 'sinh'?"));
}
