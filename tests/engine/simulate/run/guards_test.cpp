// Parts and blocks that run on condition.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/simulate/run/guard_rig.hpp"

using namespace stepwire;

namespace {

/// The pulse of the rig: on from 0.1 s, 0.5 s and 0.9 s on, for 0.2 s each. Tick 10 is the first that is on.
bool is_on(std::size_t tick) {
  return tick >= 10 && (tick - 10) % 40 < 20;
}

}  // namespace

TEST_CASE("a signal that is called as a constant hides it in conditions") {
  // Each condition becomes true at 0.3 s. Of a run of 1 s 0.7 s are left.
  const auto text = [](const std::string& name, const std::string& head, const std::string& of_x) {
    return "step: 100 ms\nstop: 1 s\nsolver: rk4\n" + head + "blocks:\n  " + name +
           ": {block: Step, time: 0.3 s}\n  x: {block: Integrator, u: 1" + of_x + "}\nrecord: [x]\n";
  };
  for (const std::string name : {"e", "pi"})
    for (const std::string events : {"", "events: locate\n"})
      for (const std::string condition :
           {name, name + " > 0.5", "2*" + name + " >= 2", "time > 0 s && !(0.5 > " + name + ")"}) {
        INFO(events << condition);
        const table::Table on = run_text(text(name, events, ", enable: \"" + condition + "\""));
        CHECK(column(on, "x").back() == Approx(0.7));
        const table::Table ended = run_text(text(name, events + "stop_when: \"" + condition + "\"\n", ""));
        CHECK(column(ended, "time").back() == 0.3);
      }
  // The other constant is one.
  CHECK(column(run_text(text("e", "", ", enable: e > pi - 3")), "x").back() == Approx(0.7));
  CHECK(column(run_text(text("pi", "", ", enable: pi > e - 2.5")), "x").back() == Approx(0.7));
}

TEST_CASE("a counter counts while it is enabled, and holds its count meanwhile") {
  const Rig rig;
  const table::Table run = rig.run("  c: {diagram: counter.yaml, enable: on}\n", "[c.count, c.active]");
  double count = 0.0;
  for (std::size_t tick = 0; tick <= 100; ++tick) {
    INFO(tick);
    if (is_on(tick)) ++count;
    CHECK(column(run, "c.count")[tick] == count);
    CHECK(column(run, "c.active")[tick] == (is_on(tick) ? 1.0 : 0.0));
  }
}

TEST_CASE(
    "states are put back as a part becomes active again, and outputs have their safe value while it is off") {
  const Rig rig;
  const table::Table run = rig.run(
      "  c: {diagram: counter.yaml, enable: {when: on, states: reset, outputs: reset}}\n"
      "  d: {diagram: counter.yaml, enable: {when: on > 0.5, outputs: 7}}\n",
      "[c.count, d.count]");
  double count = 0.0, all = 0.0;
  for (std::size_t tick = 0; tick <= 100; ++tick) {
    INFO(tick);
    count = is_on(tick) ? (tick > 0 && is_on(tick - 1) ? count : 0.0) + 1.0 : 0.0;
    all += is_on(tick) ? 1.0 : 0.0;
    CHECK(column(run, "c.count")[tick] == (is_on(tick) ? count : -1.0));
    CHECK(column(run, "d.count")[tick] == (is_on(tick) ? all : 7.0));
  }
}

TEST_CASE("continuous states stand still while they are off, to the last bit, with every solver") {
  const Rig rig;
  for (const char* solver : {"euler", "rk4", "dormand_prince", "rosenbrock", "sdirk"}) {
    INFO(solver);
    rig.folder.write("all.yaml",
                     "stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\nsolver: " + std::string(solver) +
                         "\nblocks:\n  on: {block: Pulse, period: 0.4 s, width: 50 %, delay: 0.1 s}\n"
                         "  flow: {block: Sine, amplitude: 1, frequency: 1 Hz, bias: 3}\n"
                         "  t: {diagram: tank.yaml, flow: flow, enable: on}\n"
                         "  lag: {block: Lag, u: t.twice, tau: 0.1 s}\n"
                         "record: [t.level, t.twice, lag]\n");
    const table::Table run = rig.folder.run("all.yaml");
    const auto &level = column(run, "t.level"), &twice = column(run, "t.twice");
    CHECK(level[0] == 2.0);
    const double pi = std::acos(-1.0);
    double exact = 2.0;
    for (std::size_t tick = 1; tick <= 100; ++tick) {
      INFO(tick);
      if (!is_on(tick - 1)) CHECK(level[tick] == level[tick - 1]);
      if (!is_on(tick)) CHECK(twice[tick] == twice[tick - 1]);
      if (is_on(tick)) CHECK(twice[tick] == 2.0 * level[tick]);
      const double from = 0.01 * static_cast<double>(tick - 1), to = from + 0.01;
      if (is_on(tick - 1)) exact += 3.0 * 0.01 - (std::cos(2 * pi * to) - std::cos(2 * pi * from)) / (2 * pi);
      CHECK(level[tick] == Approx(exact).margin(std::string(solver) == "euler" ? 0.06 : 1e-4));
    }
  }
}

TEST_CASE("a part that is on all the time gives the bits that it gives without a condition") {
  const Rig rig;
  const char* const blocks =
      "  flow: {block: Sine, amplitude: 1, frequency: 1 Hz}\n"
      "  t: {diagram: tank.yaml, flow: flow, enable: 1}\n  u: {diagram: tank.yaml, flow: flow}\n";
  const table::Table run = rig.run(blocks, "[t.twice, u.twice]");
  CHECK(column(run, "t.twice") == column(run, "u.twice"));
}

TEST_CASE("a trigger runs a part once for each edge, and never at the first tick") {
  const Rig rig;
  const auto counts = [&](const std::string& edge) {
    const table::Table run = rig.run(
        "  off: {block: Logic, u: on, operator: not}\n"
        "  c: {diagram: counter.yaml, trigger: {when: off, edge: " +
            edge + "}}\n",
        "[c.count, c.active]");
    return column(run, "c.count");
  };
  const auto rising = counts("rising"), falling = counts("falling"), either = counts("either");
  double rises = 0.0, falls = 0.0;
  for (std::size_t tick = 0; tick <= 100; ++tick) {
    INFO(tick);
    if (tick > 0 && is_on(tick - 1) && !is_on(tick)) ++rises;  // of `off`
    if (tick > 0 && !is_on(tick - 1) && is_on(tick)) ++falls;
    CHECK(rising[tick] == rises);
    CHECK(falling[tick] == falls);
    CHECK(either[tick] == rises + falls);
  }
}

TEST_CASE("a trigger in a part that is off sees no edge, and goes on from what it saw last") {
  DiagramFolder folder;
  folder.write("counter.yaml", counter);
  folder.write("outer.yaml",
               "stepwire: 1\ntitle: o\ninputs: {edge: {}}\noutputs: {count: c.count}\n"
               "blocks:\n  c: {diagram: counter.yaml, trigger: edge}\n");
  // The outer part is on from tick 2 to 5 and from 8 on; the signal is high at the ticks 4, 5, 6 and 9.
  folder.write("all.yaml",
               "stepwire: 1\ntitle: a\nstep: 1 s\nstop: 10 s\nblocks:\n"
               "  t: {block: Clock}\n"
               "  on: {block: Expression, u: t, expression: \"(u >= 2 && u <= 5) || u >= 8\"}\n"
               "  high: {block: Expression, u: t, expression: \"(u >= 4 && u <= 6) || u == 9\"}\n"
               "  o: {diagram: outer.yaml, edge: high, enable: on}\n"
               "  r: {diagram: outer.yaml, edge: high, enable: {when: on, states: reset}}\n"
               "record: [o.count, r.count, o.c.active]\n");
  const table::Table run = folder.run("all.yaml");
  CHECK(column(run, "o.count") == std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2});
  CHECK(column(run, "r.count") == std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1});
  CHECK(column(run, "o.c.active") == std::vector<double>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
}

TEST_CASE("conditions are formulas of signals, parameters and the time, with units") {
  const Rig rig;
  const table::Table run = rig.run(
      "  x: {block: Ramp, slope: 10 mm/s}\n"
      "  a: {diagram: counter.yaml, enable: \"x > 4 mm && time < $until\"}\n"
      "  b: {diagram: counter.yaml, enable: \"= x > from\"}\n  c: {diagram: counter.yaml, enable: $is}\n"
      "  d: {diagram: counter.yaml, enable: $is < 1 && x > 5 mm}\n",
      "[a.count, b.count, c.count, d.count]", "parameters: {until: 0.8 s, from: 5 mm, is: 0}\n");
  // x > 4 mm from tick 41 on; time < 0.8 s until tick 79.
  CHECK(column(run, "a.count").back() == 39.0);
  CHECK(column(run, "b.count").back() == 50.0);
  CHECK(column(run, "c.count").back() == 0.0);
  CHECK(column(run, "d.count").back() == 50.0);
  const auto faults = rig.faults(
      "  x: {block: Ramp, slope: 10 mm/s}\n"
      "  a: {diagram: counter.yaml, enable: \"x > 4 kg\"}\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("all.yaml:9:") != std::string::npos);
}

TEST_CASE("every of a part is that of its blocks, and others must be multiples of it") {
  const Rig rig;
  const table::Table run = rig.run("  c: {diagram: counter.yaml, every: 50 ms}\n", "[c.count]");
  CHECK(column(run, "c.count").back() == 21.0);
  CHECK(rig.faults("  t: {diagram: tank.yaml, flow: on, every: 50 ms}\n").size() == 1);
  rig.folder.write(
      "slow.yaml",
      "stepwire: 1\ntitle: s\noutputs: {y: d}\nblocks:\n  d: {block: UnitDelay, u: 1, every: 75 ms}\n");
  const auto faults = rig.faults("  s: {diagram: slow.yaml, every: 50 ms}\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("whole multiple of the 0.05 s") != std::string::npos);
}

TEST_CASE("a block may have the keys of a part") {
  const Rig rig;
  const table::Table run = rig.run(
      "  sum: {block: DiscreteIntegrator, u: 1, every: 10 ms, enable: on}\n"
      "  x: {block: Integrator, u: 1, enable: {when: on, states: reset, outputs: -3}}\n"
      "  y: {block: Gain, u: x, gain: 1}\n",
      "[sum, x, y, sum.active]");
  for (std::size_t tick = 0; tick <= 100; ++tick) {
    INFO(tick);
    const std::size_t since = (tick - 10) % 40;
    const double expected = is_on(tick) ? 0.01 * static_cast<double>(since) : -3.0;
    CHECK(column(run, "x")[tick] == Approx(expected).margin(1e-14));
    CHECK(column(run, "y")[tick] == column(run, "x")[tick]);
  }
}

TEST_CASE("a block with a trigger of its own for its reset has a condition as a map") {
  const Rig rig;
  const table::Table run = rig.run(
      "  c: {block: DiscreteIntegrator, u: 100, every: 10 ms, trigger: {when: on, edge: either}}\n"
      "  x: {block: Integrator, u: 1, reset: on, trigger: falling, enable: {when: on}}\n"
      "  y: {block: Integrator, u: 1, reset: on, trigger: falling, enable: time >= 0 s}\n",
      "[c, c.active, x, y]");
  double count = 0.0;
  for (std::size_t tick = 1; tick <= 100; ++tick) {
    INFO(tick);
    const bool edge = is_on(tick) != is_on(tick - 1);
    CHECK(column(run, "c.active")[tick] == (edge ? 1.0 : 0.0));
    if (edge) CHECK(column(run, "c")[tick] == count++);
    if (edge && !is_on(tick)) CHECK(column(run, "y")[tick] == 0.0);
  }
  CHECK(count == 5.0);
  CHECK(column(run, "x").back() == Approx(0.5));  // off when the signal falls, so that nothing resets it
}

TEST_CASE("a condition in the place of the word for a reset is refused with the form that is one") {
  const Rig rig;
  const auto faults = rig.faults("  c: {block: Integrator, u: 1, trigger: on > 0.5}\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("{when: on > 0.5}") != std::string::npos);
  CHECK(faults[0].find("rising, falling, either, level") != std::string::npos);
}

TEST_CASE("a condition on several numbers is refused where it stands") {
  CHECK_THAT(faults_of("blocks:\n  v: {block: Constant, value: [1, 2]}\n"
                       "  g: {block: Gain, u: v, enable: v > 1}\n")[0],
             Catch::Contains(":3:34: g.enable_when.u: has 2 elements; 1 would fit"));
}

TEST_CASE("a condition that follows from what it guards is an algebraic loop, and says so") {
  const Rig rig;
  const auto faults = rig.faults("  c: {diagram: counter.yaml, enable: c.count < 5}\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("algebraic loop") != std::string::npos);
  CHECK(faults[0].find("c.active decides whether") != std::string::npos);
}

TEST_CASE("what is triggered integrates nothing, and needs a period where blocks compute with one") {
  const Rig rig;
  CHECK(rig.faults("  t: {diagram: tank.yaml, flow: on, trigger: on}\n").front().find("stand still") !=
        std::string::npos);
  rig.folder.write("pid.yaml",
                   "stepwire: 1\ntitle: p\ninputs: {e: {}}\noutputs: {y: i}\nblocks:\n"
                   "  i: {block: DiscreteIntegrator, u: e, method: forward_euler}\n");
  CHECK(rig.faults("  p: {diagram: pid.yaml, e: on, trigger: on}\n").front().find("give what is triggered") !=
        std::string::npos);
  const table::Table run = rig.run("  p: {diagram: pid.yaml, e: 1, trigger: on, every: 50 ms}\n", "[p.y]");
  // Edges at 0.1 s, 0.5 s and 0.9 s, each of which counts 50 ms; the sum is of those before.
  CHECK(column(run, "p.y").back() == Approx(0.1));
}
