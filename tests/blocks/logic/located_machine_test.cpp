// Transitions of a StateMachine with `events: locate`.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::string head(const std::string& stop, const std::string& step = "0.1 s",
                 const std::string& events = "locate") {
  return "step: " + step + "\nstop: " + stop +
         "\nsolver: {name: dormand_prince, relative: 1e-10}\nevents: " + events + "\n";
}

double last(const table::Table& table, const std::string& name) {
  return column(table, name).back();
}

}  // namespace

TEST_CASE("A machine that heats below 18 and rests above 22 follows its exponentials") {
  const table::Table table = run_text(head("2 s") + R"(blocks:
  x: {block: Integrator, u: rate, initial: 20}
  heater: {block: StateMachine, u: x, states: {on: {output: 30, to: {rest: u > 22}}, rest: {to: {on: u < 18}}}}
  rate: {block: Sum, u: [heater.y, x], signs: "+-"}
record: [x, heater.state]
)");
  // x = 30 - 10 exp(-t), 22 exp(-t), 30 - 12 exp(-t), 22 exp(-t), 30 - 12 exp(-t), ... from 20 on.
  double at = 2.0 - std::log(10.0 / 8.0), from = 22.0;
  bool heats = false;
  while (true) {
    const double length = heats ? std::log(12.0 / 8.0) : std::log(22.0 / 18.0);
    if (at < length) break;
    at -= length;
    heats = !heats;
    from = heats ? 18.0 : 22.0;
  }
  const double right = heats ? 30.0 - (30.0 - from) * std::exp(-at) : from * std::exp(-at);
  CHECK(last(table, "x") == Approx(right).epsilon(1e-8));
  CHECK(last(table, "heater.state") == (heats ? 0.0 : 1.0));
}

TEST_CASE("A timeout between two ticks acts at its instant, and the next one counts from there") {
  const table::Table table = run_text(head("1 s") + R"(blocks:
  m: {block: StateMachine, states: {a: {output: 1, timeout: {b: 0.25 s}}, b: {timeout: {a: 0.33 s}}}}
  x: {block: Integrator, u: m.y}
record: [x, m.state]
)");
  CHECK(last(table, "x") == Approx(0.25 + 0.25).epsilon(1e-12));  // 0 to 0.25 s, 0.58 to 0.83 s
}

TEST_CASE("A guard on the time in a state is read at ticks from the instant of the entry on") {
  const table::Table table = run_text(head("1 s") + R"(blocks:
  t: {block: Clock}
  m:
    block: StateMachine
    u: t
    counters: {length: 0}
    states:
      a: {to: {b: u > 0.33}}
      b: {each: {length: after}, to: {c: after > 0.45}}
      c: {output: 1}
  x: {block: Integrator, u: m.y}
record: [x, m.counts]
)");
  CHECK(last(table, "m.counts") == Approx(0.7 - 0.33).epsilon(1e-10));  // at the last tick in b
  CHECK(last(table, "x") == Approx(1.0 - 0.33 - 0.45).epsilon(1e-10));
}

TEST_CASE("An instant between ticks has one transition at most, and settings of a tick act at ticks alone") {
  const table::Table table = run_text(head("0.5 s") + R"(blocks:
  t: {block: Clock}
  m:
    block: StateMachine
    u: t
    counters: {ticks: 0, entries: 0}
    states:
      a: {each: {ticks: ticks + 1}, to: {b: u > 0.25}}
      b: {enter: {entries: entries + 1}, each: {ticks: ticks + 1}, to: {c: u > 0.25}}
      c: {enter: {entries: entries + 1}, each: {ticks: ticks + 1}}
record: [m.state, m.counts]
)");
  CHECK(column(table, "m.state") == std::vector<double>{0, 0, 0, 2, 2, 2});
  CHECK(column(table, "m.counts.1") == std::vector<double>{1, 2, 3, 3, 4, 5});  // at 0.3 s it moves on to c
  CHECK(last(table, "m.counts.2") == 2.0);
}

TEST_CASE("A machine with a period of its own keeps to its ticks") {
  const table::Table table = run_text(head("1 s") + R"(blocks:
  t: {block: Clock}
  m: {block: StateMachine, u: t, every: 0.2 s, states: {a: {to: {b: u > 0.33}}, b: {output: 1}}}
  x: {block: Integrator, u: m.y}
record: [x]
)");
  CHECK(last(table, "x") == Approx(0.6));
}

TEST_CASE("States that hold others are located with their own guards") {
  const table::Table table = run_text(head("1 s") + R"(blocks:
  t: {block: Clock}
  m:
    block: StateMachine
    u: t
    states:
      on: {to: {off: u >= 0.62}, states: {slow: {output: 1, to: {fast: u >= 0.25}}, fast: {output: 2}}}
      off: {}
  x: {block: Integrator, u: m.y}
record: [x]
)");
  CHECK(last(table, "x") == Approx(0.25 + 2.0 * 0.37).epsilon(1e-10));
}

TEST_CASE("A timeout that ends on a tick acts at this tick, and each tick counts once") {
  for (const std::string step : {"0.1 s", "10 ms", "1 ms"}) {
    const table::Table table = run_text(head("1 s", step) + R"(blocks:
  m:
    block: StateMachine
    counters: {n: 0}
    states: {a: {timeout: {b: 0.3 s}}, b: {output: 1, each: {n: n + 1}, timeout: {c: 0.3 s}}, c: {}}
  x: {block: Integrator, u: m.y}
  other: {block: StateMachine, counters: {n: 0}, states: {a: {each: {n: n + 1}}}}
record: [x, m.counts, other.counts]
)");
    const double ticks = static_cast<double>(column(table, "time").size());
    INFO(step);
    CHECK(last(table, "x") == Approx(0.3).epsilon(1e-10));
    CHECK(last(table, "m.counts") == Approx(0.3 * (ticks - 1.0) - 1.0));  // not at the two transitions
    CHECK(last(table, "other.counts") == ticks);
  }
}

TEST_CASE("A machine in a part that begins between ticks counts from there") {
  const Scratch folder;
  io::write_file(folder.path("part.yaml"), R"(stepwire: 1
title: part
blocks:
  m: {block: StateMachine, states: {a: {timeout: {b: 0.42 s}}, b: {output: 1}}}
outputs: {y: m.y}
)");
  const table::Table table =
      run_text(head("1 s") + "blocks:\n  t: {block: Clock}\n  p: {diagram: " + folder.path("part.yaml") +
               R"(, enable: {when: t > 0.27 s, states: reset}}
  x: {block: Integrator, u: p.y}
record: [x]
)");
  CHECK(last(table, "x") == Approx(1.0 - 0.27 - 0.42).epsilon(1e-9));
}

TEST_CASE("A held machine counts the time in which its part is active, to the instant") {
  const Scratch folder;
  io::write_file(folder.path("part.yaml"), R"(stepwire: 1
title: part
blocks:
  m:
    block: StateMachine
    counters: {n: 0}
    states: {a: {each: {n: n + 1}, timeout: {b: 0.42 s}}, b: {output: 1}}
outputs: {y: m.y, n: m.counts}
)");
  struct Case {
    std::string active;
    double at, ticks;  // instant of the transition [s]; number of ticks in the first state
  };
  const Case cases[] = {{"t < 0.27 s || t > 0.51 s", 0.66, 4},
                        {"t < 0.23 s || t > 0.27 s", 0.46, 5},
                        {"t < 0.27 s || t >= 0.5 s", 0.65, 5},
                        {"t < 0.3 s || t > 0.51 s", 0.63, 4},
                        {"t < 0.3 s || t >= 0.5 s", 0.62, 5},
                        {"t < 0.23 s || (t > 0.27 s && t < 0.36 s) || t > 0.71 s", 0.81, 5},
                        {"t > 0.05 s && t < 0.15 s || t > 0.55 s", 0.87, 4}};
  for (const Case& one : cases) {
    const table::Table table =
        run_text(head("1 s", "0.1 s", "{looks: 19}") + "blocks:\n  t: {block: Clock}\n  p: {diagram: " +
                 folder.path("part.yaml") + ", enable: \"" + one.active + R"("}
  x: {block: Integrator, u: p.y}
record: [x, p.n]
)");
    INFO(one.active);
    CHECK(last(table, "x") == Approx(1.0 - one.at).epsilon(1e-9));
    CHECK(last(table, "p.n") == one.ticks);
  }
}

TEST_CASE("All guards of a state are located, however many there are") {
  for (const int number : {1, 8, 9, 20}) {
    std::string guards, states;
    for (int g = 1; g < number; ++g) guards += "{to: s" + std::to_string(g) + ", when: u > 5}, ";
    for (int g = 1; g < number; ++g) states += ", s" + std::to_string(g) + ": {}";
    const table::Table table =
        run_text(head("1 s") + R"(blocks:
  t: {block: Clock}
  m: {block: StateMachine, u: t, states: {a: {to: [)" +
                 guards + "{to: last, when: u > 0.33}]}" + states + R"(, last: {output: 1}}}
  x: {block: Integrator, u: m.y}
record: [x]
)");
    INFO(number);
    CHECK(last(table, "x") == Approx(0.67).epsilon(1e-10));
  }
}

TEST_CASE("An equality beside another condition does not hide it") {
  for (const std::string guard : {"mode != 3 && x > 0.55", "mode == 0 || x > 0.55",
                                  "!(mode == 0) && x > 0.55", "!(mode != 1) && x > 0.55"}) {
    const table::Table table = run_text(head("1 s") + R"(blocks:
  t: {block: Clock}
  mode: {block: Constant, value: 1}
  m: {block: StateMachine, u: [t, mode], variables: [x, mode], states: {a: {to: {b: ")" +
                                        guard + R"("}}, b: {output: 1}}}
  e: {block: Expression, u: [t, mode], variables: [x, mode], expression: ")" +
                                        guard + R"("}
  x: {block: Integrator, u: m.y}
  z: {block: Integrator, u: e}
record: [x, z]
)");
    INFO(guard);
    CHECK(last(table, "x") == Approx(0.45).epsilon(1e-9));
    CHECK(last(table, "z") == Approx(0.45).epsilon(1e-9));
  }
}
