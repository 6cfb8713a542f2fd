// Cases of others: what is read, counted and reset at one instant.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

std::string with(const std::string& head, const std::string& blocks, const std::string& record) {
  return head + "blocks:\n" + blocks + "record: " + record + "\n";
}

const char* const solvers[] = {"euler",
                               "heun",
                               "bogacki_shampine",
                               "rk4",
                               "dormand_prince",
                               "rosenbrock",
                               "sdirk",
                               "{name: dormand_prince, relative: 1e-8}",
                               "auto"};

}  // namespace

TEST_CASE("two states that are reset to each other at one instant are exchanged") {
  for (const char* solver : solvers)
    for (const char* events : {"tick", "locate"}) {
      INFO(solver << " " << events);
      const std::string head =
          std::string("step: 0.1 s\nstop: 1 s\nsolver: ") + solver + "\nevents: " + events;
      const table::Table run = run_text(with(head + "\n",
                                             "  e: {block: Step, time: 0.5 s}\n"
                                             "  x: {block: Integrator, u: 1, reset: e, value: y.before}\n"
                                             "  y: {block: Integrator, u: -1, initial: 3, reset: e, value: "
                                             "x.before}\n",
                                             "[x, y]"));
      CHECK(column(run, "x")[5] == Approx(2.5));
      CHECK(column(run, "y")[5] == Approx(0.5));
      CHECK(last(run, "x") == Approx(3.0));
      CHECK(last(run, "y") == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("two equal masses exchange their velocities, whichever is named first") {
  for (const char* names : {"ab", "ba"}) {
    const std::string one(1, names[0]), other(1, names[1]);
    const auto mass = [&](const std::string& name, const std::string& from, const char* speed) {
      return "  " + name + ": {block: Mass, force: 0 N, initial_velocity: " + speed +
             ", reset: e, value: " + from + ".velocity}\n";
    };
    const table::Table run = run_text(
        with("step: 0.1 s\nstop: 1 s\nsolver: rk4\n",
             "  e: {block: Step, time: 0.5 s}\n" + mass(one, other, "1 m/s") + mass(other, one, "-2 m/s"),
             "[" + one + ".velocity, " + other + ".velocity]"));
    CHECK(last(run, one + ".velocity") == Approx(-2.0));
    CHECK(last(run, other + ".velocity") == Approx(1.0));
  }
}

TEST_CASE("a lag and a controller that are reset to a state read it as it was before") {
  for (const char* block : {"Lag, u: 0, tau: 1e9", "PID, u: 0, kp: 0, ki: 0"}) {
    const table::Table run = run_text(
        with("step: 0.1 s\nstop: 1 s\nsolver: rk4\n",
             "  e: {block: Step, time: 0.5 s}\n  x: {block: Integrator, u: 1 1/s, reset: e}\n  z: {block: " +
                 std::string(block) + ", reset: e, value: x.before}\n",
             "[z]"));
    CHECK(column(run, "z")[5] == Approx(0.5));
    CHECK(last(run, "z") == Approx(0.5));
  }
}

TEST_CASE("a solver that chooses its steps finds each crossing inside of them") {
  // 77.283 sin(w t) / w passes 0 every pi / w; the first time at the start.
  const double w = std::sqrt(5972.65);
  const double times = 1.0 + std::floor(4.0 * w / std::numbers::pi);
  for (const char* name : {"dormand_prince", "bogacki_shampine", "rodas"})
    for (const char* step : {"10 ms", "0.1 s", "1 s"}) {
      INFO(name << " " << step);
      const table::Table run =
          run_text(with(std::string("events: locate\nstop: 4 s\nstep: ") + step + "\nsolver: {name: " + name +
                            ", relative: 1e-8, absolute: 1e-10}\n",
                        "  a: {block: Gain, u: s, gain: -5972.65}\n"
                        "  v: {block: Integrator, u: a, initial: 77.283}\n"
                        "  s: {block: Integrator, u: v}\n"
                        "  c: {block: Compare, u: s, to: 0, operator: '>'}\n"
                        "  n: {block: Counter, u: c, count_at: either}\n",
                        "[n]"));
      CHECK(last(run, "n") == times);
    }
}

TEST_CASE("a branch that a stage would take too early has the accuracy of one that is a mode") {
  // x'' = -sign(x) from 1: parabolas, a quarter of whose period is sqrt(2).
  const auto end = [](const std::string& law, const char* solver) {
    return last(
        run_text(with(std::string("events: locate\nstep: 10 ms\nstop: 3 s\nsolver: ") + solver + "\n",
                      "  s: {block: " + law +
                          "}\n  v: {block: Integrator, u: s}\n  x: {block: Integrator, u: v, initial: 1}\n",
                      "[x]")),
        "x");
  };
  const double since = 3.0 - std::sqrt(2.0), right = -std::sqrt(2.0) * since + 0.5 * since * since;
  for (const char* solver : {"heun", "rk4", "dormand_prince", "sdirk"})
    for (const char* law :
         {"Switch, control: x, then: -1, else: 1", "Expression, u: x, expression: \"u > 0 ? -1 : 1\"",
          "Expression, u: x, expression: 1 - 2*(u > 0)"}) {
      INFO(solver << " " << law);
      CHECK(end(law, solver) == Approx(right).epsilon(1e-7));
    }
}

TEST_CASE("a switch by the clock acts at its instant") {
  for (const char* solver : {"euler", "heun", "rk4", "dormand_prince", "sdirk"}) {
    const table::Table run =
        run_text(with(std::string("events: locate\nstep: 0.1 s\nstop: 1 s\nsolver: ") + solver + "\n",
                      "  k: {block: Clock}\n"
                      "  s: {block: Switch, control: k, threshold: 0.537 s, then: 1, else: 0}\n"
                      "  i: {block: Integrator, u: s}\n",
                      "[i]"));
    INFO(solver);
    CHECK(last(run, "i") == Approx(0.463).epsilon(1e-10));
  }
}

TEST_CASE("three crossings in one step are all found") {
  for (const char* events : {"locate", "{looks: 16}"}) {
    const table::Table run = run_text(with(std::string("step: 0.1 s\nstop: 2 s\nevents: ") + events + "\n",
                                           "  s: {block: Sine, frequency: 12.3 Hz, phase: 0.1 rad}\n"
                                           "  c: {block: Compare, u: s, to: 0, operator: '>'}\n"
                                           "  n: {block: Counter, u: c, count_at: either}\n",
                                           "[n]"));
    CHECK(last(run, "n") == 49.0);
  }
}

TEST_CASE("two crossings within less than a fifth of a step are found, with every solver") {
  // (t - 45.2 ms)^2 is below (0.4 ms)^2 for 0.8 ms of a step of 10 ms.
  for (const char* solver :
       {"heun", "rk4", "dormand_prince", "rosenbrock", "sdirk", "dop853", "radau", "rodas", "auto",
        "{name: dormand_prince, relative: 1e-7}", "{name: bogacki_shampine, relative: 1e-7}"}) {
    INFO(solver);
    const table::Table run =
        run_text(with(std::string("events: locate\nstep: 10 ms\nstop: 0.1 s\nsolver: ") + solver + "\n",
                      "  v: {block: Integrator, u: 2, initial: -0.0904 s}\n"
                      "  x: {block: Integrator, u: v, initial: 0.00204304 s^2}\n"
                      "  c: {block: Compare, u: x, operator: '<', to: 1.6e-7 s^2}\n"
                      "  n: {block: Counter, u: c, count_at: either}\n"
                      "  i: {block: Integrator, u: c}\n",
                      "[n, i]"));
    CHECK(last(run, "n") == 2.0);
    CHECK(last(run, "i") == Approx(8e-4).epsilon(1e-6));
  }
}

TEST_CASE("an event at the stop time belongs to the run, with every solver") {
  // x = t meets its threshold at the last tick, where rounding leaves it below or above.
  for (const char* solver : {"euler", "heun", "rk4", "dormand_prince", "rosenbrock", "sdirk", "dop853",
                             "radau", "rodas", "auto", "{name: dormand_prince, relative: 1e-6}"})
    for (const auto& [step, stop] : std::vector<std::pair<std::string, std::string>>{
             {"0.1 s", "1 s"}, {"0.1 s", "0.3 s"}, {"10 ms", "0.7 s"}, {"1 ms", "1.1 s"}}) {
      INFO(solver << " " << step << " " << stop);
      const table::Table run = run_text(
          with("events: locate\nstep: " + step + "\nstop: " + stop + "\nsolver: " + solver + "\n",
               "  x: {block: Integrator, u: 1}\n"
               "  c: {block: Compare, u: x, operator: '>=', to: " +
                   stop + "}\n  n: {block: Counter, u: c}\n  z: {block: Integrator, u: 1, reset: c}\n",
               "{signals: [c, n, z], instants: true}"));
      const std::vector<double> c = column(run, "c"), time = column(run, "time");
      const auto row = static_cast<std::size_t>(std::ranges::find(c, 1.0) - c.begin());
      REQUIRE(row < c.size());
      CHECK(time[row] == Approx(time.back()).epsilon(1e-12));
      CHECK(time[row - 1] == time[row]);
      CHECK(last(run, "c") == 1.0);
      CHECK(last(run, "n") == 1.0);
      CHECK(last(run, "z") == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("short turns of an oscillation and of a signal of time alone are found") {
  // sin(2 pi t) exceeds cos(2 pi 0.3 ms) for 0.6 ms about its maximum at 0.25 s, and at each second after.
  const std::string of_time = "  x: {block: Sine, frequency: 1 Hz}\n";
  const std::string of_states =
      "  v: {block: Integrator, u: a, initial: 6.283185307179586 1/s}\n"
      "  a: {block: Gain, u: x, gain: -39.47841760435743 1/s^2}\n"
      "  x: {block: Integrator, u: v}\n";
  const std::string fine = ", relative: 1e-11, absolute: 1e-12}";
  for (const auto& [signal, solver] :
       std::vector<std::pair<std::string, std::string>>{{of_time, "dormand_prince"},
                                                        {of_states, "dormand_prince"},
                                                        {of_time, "{name: dop853" + fine},
                                                        {of_states, "{name: dop853" + fine},
                                                        {of_states, "{name: dormand_prince" + fine},
                                                        {of_states, "{name: radau" + fine}}) {
    INFO(signal << solver);
    const table::Table run =
        run_text(with("events: locate\nstep: 7 ms\nstop: 4.9 s\nsolver: " + solver + "\n",
                      signal + "  c: {block: Compare, u: x, operator: '>', to: 0.9999982234720354}\n"
                               "  n: {block: Counter, u: c}\n"
                               "  i: {block: Integrator, u: c}\n",
                      "[n, i]"));
    CHECK(last(run, "n") == 5.0);
    CHECK(last(run, "i") == Approx(3e-3).epsilon(solver == "dop853" ? 1e-4 : 3e-4));
  }
}

TEST_CASE("more looks than usual are taken in every step") {
  // 20 short times above 0.99, two in each step of 0.4 s.
  const table::Table run = run_text(with("step: 0.4 s\nstop: 4 s\nevents: {looks: 60}\n",
                                         "  s: {block: Sine, frequency: 5 Hz, phase: 0.3 rad}\n"
                                         "  c: {block: Compare, u: s, to: 0.99, operator: '>'}\n"
                                         "  n: {block: Counter, u: c}\n",
                                         "[n]"));
  CHECK(last(run, "n") == 20.0);
}

TEST_CASE("a level counts ticks, also where events are located") {
  const table::Table run = run_text(with("events: locate\nstep: 10 ms\nstop: 1 s\nsolver: rk4\n",
                                         "  s: {block: Sine, frequency: 1 Hz, bias: -0.5}\n"
                                         "  c: {block: Compare, u: s, to: 0, operator: '>'}\n"
                                         "  n: {block: Counter, u: c, count_at: level}\n"
                                         "  i: {block: Integrator, u: c}\n",
                                         "[n, i]"));
  CHECK(last(run, "n") == 33.0);  // ticks from 90 ms to 410 ms
  CHECK(last(run, "i") == Approx(1.0 / 3.0).epsilon(1e-9));
}

TEST_CASE("an assertion fails at the instant at which it becomes false") {
  const std::string fault = error_of(with("events: locate\nstep: 0.1 s\nstop: 3 s\nsolver: rk4\n",
                                          "  x: {block: Integrator, u: 1 1/s}\n"
                                          "  low: {block: Compare, u: x, operator: '<', to: 1.5037}\n"
                                          "  hold: {block: Assert, u: low}\n",
                                          "[x]"));
  CHECK_THAT(fault, Catch::Contains("1.5037"));
}

}  // namespace stepwire::run
