#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

TEST_CASE("both ends are recorded, and nothing is updated behind the stop") {
  const plan::Plan plan = plan_text(
      "step: 0.1 s\nstop: 0.5 s\nblocks:\n  count: {block: Sum, u: [1, last]}\n  last: {block: UnitDelay, u: "
      "count}\nrecord: [count, last]\n");
  const RunResult result = run_plan(plan);
  const table::Table& table = result.recordings.front().table;
  CHECK(table.rows() == 6);
  CHECK(column(table, "time").front() == 0.0);
  CHECK(column(table, "time").back() == 0.5);
  CHECK(column(table, "count") == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(column(table, "last").back() == 5.0);
  CHECK(result.ticks == 5);
}

TEST_CASE("a signal that is no longer finite ends the run with its block, port and time") {
  // 1 / (3 - t) at steps of 1 s: infinite at 3 s.
  const RunResult result = result_of(R"(blocks:
  t: {block: Clock}
  left: {block: Sum, signs: "+-", u: [3 s, t]}
  inverse: {block: Divide, numerator: 1, denominator: left}
  behind: {block: Gain, gain: 0, u: inverse}
stop: 10 s
record: [inverse, behind]
)");
  REQUIRE(result.faults.size() == 1);
  CHECK(result.faults[0].block == "inverse");
  CHECK(result.faults[0].port == "y");
  CHECK(result.faults[0].time == 3.0);
  CHECK_THAT(result.faults[0].fault.text(),
             Catch::StartsWith("test.yaml:4:12: inverse.y: became inf at 3 s; the run ends here"));
  CHECK(column(result.recordings[0].table, "inverse") == std::vector<double>{1.0 / 3, 0.5, 1});
}

TEST_CASE("a state that runs away is named, not what follows from it") {
  const RunResult result = result_of(R"(blocks:
  rate: {block: Gain, gain: 0.5, u: x}
  x: {block: Integrator, u: rate, initial: 1}
step: 4 s
stop: 4000 s
solver: euler
record: x
)");
  REQUIRE(result.faults.size() == 1);
  CHECK(result.faults[0].block == "x");
  CHECK(result.recordings[0].table.rows() > 3);
  for (double value : column(result.recordings[0].table, "x")) CHECK(std::isfinite(value));
}

TEST_CASE("an assertion that fails ends the run and keeps the row at which it failed") {
  const RunResult result = result_of(R"(blocks:
  t: {block: Clock}
  early: {block: Compare, operator: "<", u: t, to: 3 s}
  stays_early: {block: Assert, u: early}
stop: 10 s
record: t
)");
  REQUIRE(result.faults.size() == 1);
  CHECK(result.faults[0].block == "stays_early");
  CHECK(result.faults[0].time == 3.0);
  CHECK(column(result.recordings[0].table, "t") == std::vector<double>{0, 1, 2, 3});
}

TEST_CASE("an assertion that fails at the last row ends the run with its fault") {
  // x = t is below 0.95 until the last row at 1 s; the Step falls there; `stop_when` ends a run at 1 s, too.
  const std::string sinks = R"(  x: {block: Integrator, u: 1}
  low: {block: Compare, u: x, operator: "<", to: 0.95}
  fall: {block: Step, time: 1 s, before: 1, after: 0}
)";
  for (const char* head : {"stop: 1 s\n", "stop: 1 s\nevents: locate\n", "stop: 2 s\nstop_when: x > 0.95\n"})
    for (const char* condition : {"low", "fall"}) {
      INFO(head << condition);
      const RunResult result = result_of("step: 100 ms\nsolver: rk4\n" + std::string(head) + "blocks:\n" +
                                         sinks + "  a: {block: Assert, u: " + condition + "}\nrecord: [x]\n");
      REQUIRE(result.faults.size() == 1);
      CHECK(result.faults[0].block == "a");
      CHECK(result.faults[0].time ==
            Approx(std::string(head).find("locate") != std::string::npos && std::string(condition) == "low"
                       ? 0.95
                       : 1.0));
    }
}

/// Has `text` in its fault or in one of its diagnostics, with the time of the last row.
bool tells_at(const RunResult& result, const std::string& text, double time) {
  for (const RunFault& fault : result.faults)
    if (fault.fault.text().find(text) != std::string::npos && fault.time == time) return true;
  for (const RaisedDiagnostic& one : result.diagnostics)
    if (one.text.find(text) != std::string::npos && one.time == time) return true;
  return false;
}

TEST_CASE("what blocks find wrong at the last row alone is told") {
  // 100 t leaves each range between the rows at 0.9 s and 1 s.
  for (const auto& [block, text] : std::vector<std::pair<std::string, std::string>>{
           {"{block: Interlock, u: 1, faults: [over], stop: true}", "the commands are cut off"},
           {"{block: Interlock, u: 1, faults: [over]}", "the commands are cut off"},
           {"{block: Sensor, u: x, upper: 95, seed: 1, every: 100 ms}", "range"},
           {"{block: AnalogToDigital, u: x, range: 95 V, bits: 12, every: 100 ms}", "leaves the range"},
           {"{block: TransportDelay, u: x, delay: d, longest: 1 s}", "the delay is below a step"}}) {
    INFO(block << ": " << text);
    const RunResult result = result_of(R"(blocks:
  x: {block: Ramp, slope: 100}
  over: {block: Compare, u: x, operator: ">", to: 95}
  d: {block: Switch, control: over, then: 2.5 s, else: 0.5 s}
  a: )" + block + "\nstep: 100 ms\nstop: 1 s\nrecord: [x]\n");
    CHECK(tells_at(result, text, 1.0));
  }
}

TEST_CASE("a solver that a switch holds at its threshold names a cure that is not itself") {
  // x' = -sign(x) + 0.5 reaches 0 at 0.4 s and stays there: between steps, x' has no value.
  for (const std::string solver : {"radau", "rodas", "auto", "dormand_prince", "dop853"}) {
    INFO(solver);
    const std::string error = error_of("step: 0.1 s\nstop: 1 s\nsolver: {name: " + solver +
                                       ", relative: 1e-6, max_steps: 300}\nblocks:\n"
                                       "  s: {block: Sign, u: x}\n"
                                       "  x: {block: Integrator, u: d, initial: 0.2}\n"
                                       "  d: {block: Sum, u: [0.5, s], signs: \"+-\"}\nrecord: [x]\n");
    CHECK_THAT(error, Catch::Contains("max_steps") && Catch::Contains("a hysteresis, a Friction block"));
    const bool stiff = solver != "dormand_prince" && solver != "dop853";
    CHECK((error.find("A stiff solver") == std::string::npos) == stiff);
  }
}

TEST_CASE("an assertion with a period is not judged at a last row between its ticks") {
  const RunResult result = result_of(R"(blocks:
  x: {block: Integrator, u: 1}
  low: {block: Compare, u: x, operator: "<", to: 0.95}
  a: {block: Assert, u: low, every: 300 ms}
step: 100 ms
stop: 1 s
solver: rk4
record: [x]
)");
  CHECK(result.faults.empty());
}

TEST_CASE("stop_when ends a run where a reset of the same instant takes its condition away") {
  // x = t is reset where its value before the reset exceeds 0.55: within the step with `locate`, else at 0.6
  // s.
  for (const char* condition : {"h > 0", "x.before > 0.55"})
    for (const char* events : {"locate", "tick"}) {
      INFO(condition << ' ' << events);
      const RunResult result = result_of(std::string("step: 100 ms\nstop: 2 s\nsolver: rk4\nevents: ") +
                                         events + "\nstop_when: " + condition + R"(
blocks:
  h: {block: Compare, u: x.before, operator: ">", to: 0.55}
  x: {block: Integrator, u: 1, reset: h}
record: [x.before]
)");
      CHECK(result.faults.empty());
      const double end = std::string(events) == "tick" ? 0.6 : 0.55;
      CHECK(column(result.recordings[0].table, "time").back() == Approx(end).epsilon(1e-11));
    }
}

TEST_CASE("what a block has to say is told once, with the time at which it happened first") {
  const RunResult result = result_of(R"(blocks:
  current: {block: Ramp, slope: 0.1 A/s}
  damper: {block: MRDamper, preset: rd-1097-01, velocity: 0.1 m/s, current: current}
step: 1 ms
stop: 6 s
solver: rk4
record: current
)");
  CHECK(result.faults.empty());
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].block == "damper");
  CHECK(result.diagnostics[0].time == Approx(3.5).margin(1.1e-3));
}

TEST_CASE("stop_when ends a run at the tick at which it holds, which is recorded") {
  const RunResult result = result_of(
      "blocks:\n  t: {block: Clock}\n  g: {block: Gain, gain: 2, u: t}\nstop: 100 s\nstop_when: g > $most && "
      "time >= 2 s\nparameters: {most: 6}\nrecord: g\n");
  CHECK(column(result.recordings[0].table, "g") == std::vector<double>{0, 2, 4, 6, 8});
  CHECK(result.faults.empty());
  CHECK_FALSE(result.interrupted);
}

TEST_CASE("stop_when reads an element of a vector") {
  const RunResult result =
      result_of("blocks:\n  r: {block: Ramp, slope: [1, 2]}\nstop: 100 s\nstop_when: r.2 >= 6\nrecord: r\n");
  CHECK(column(result.recordings[0].table, "r.1") == std::vector<double>{0, 1, 2, 3});
}

TEST_CASE("a condition over a whole vector, or an element that is not there, is refused") {
  const std::string vector = "blocks:\n  v: {block: Constant, value: [1, 2]}\nstop_when: ";
  const auto whole = faults_of(vector + "v > 3\n");
  REQUIRE(whole.size() == 1);
  CHECK_THAT(whole[0], Catch::StartsWith("test.yaml:3:12: stop_when: 'v' has 2 elements"));
  CHECK(faults_of(vector + "v.3 > 3\n") ==
        std::vector<std::string>{"test.yaml:3:12: stop_when: there is no 'v.3'; the signal has 2 elements"});
}

TEST_CASE("an interruption ends a run soon and keeps its rows") {
  const plan::Plan plan = plan_text("blocks:\n  t: {block: Clock}\nstop: 1e6 s\nrecord: t\n");
  std::atomic<bool> interrupt = false;
  RunOptions options;
  options.interrupt = &interrupt;
  options.progress = [&](double done) { interrupt = done > 0.001; };
  const RunResult result = run_plan(plan, options);
  CHECK(result.interrupted);
  const auto& t = column(result.recordings[0].table, "t");
  CHECK(t.size() > 1000);
  CHECK(t.size() < 2000);
  CHECK(t.back() == static_cast<double>(t.size() - 1));
}

TEST_CASE("the last tick of a run is recorded where the period of a record skips it") {
  const std::string blocks = "blocks:\n  t: {block: Clock}\nrecord: {every: 4 s, signals: t}\n";
  CHECK(column(result_of(blocks + "stop: 9 s\n").recordings[0].table, "t") ==
        std::vector<double>{0, 4, 8, 9});
  const RunResult early = result_of(blocks + "stop: 100 s\nstop_when: t >= 6\n");
  CHECK(column(early.recordings[0].table, "t") == std::vector<double>{0, 4, 6});
  const RunResult met = result_of(blocks + "stop: 100 s\nstop_when: t >= 8\n");
  CHECK(column(met.recordings[0].table, "t") == std::vector<double>{0, 4, 8});
}

TEST_CASE("the last row has the time of the event that ends the run, beside a delay too") {
  const table::Table run = run_text(R"(step: 0.1 s
stop: 1 s
solver: rk4
events: locate
stop_when: x > 0.55
blocks:
  x: {block: Integrator, u: 1}
  d: {block: TransportDelay, u: x, delay: 0.2 s}
record: [x, d]
)");
  CHECK(column(run, "time").back() == Approx(0.55).epsilon(1e-9));
  CHECK(column(run, "d").back() == Approx(0.35).epsilon(1e-9));
}

TEST_CASE("an assertion that fails at a located event has its row, interpreted and with both sides") {
  // x = t and d = 2 x where x reaches 0.35, within the step from 0.3 s.
  for (const char* record :
       {"[x, d]", "{instants: true, signals: [x, d]}", "{every: 0.4 s, signals: [x, d]}"}) {
    INFO(record);
    const RunResult result = result_of(R"(step: 0.1 s
stop: 1 s
solver: rk4
events: locate
blocks:
  x: {block: Integrator, u: 1}
  d: {block: Gain, gain: 2, u: x}
  low: {block: Compare, operator: "<", u: x, to: 0.35}
  a: {block: Assert, u: low}
record: )" + std::string(record) + "\n");
    REQUIRE(result.faults.size() == 1);
    CHECK(result.faults[0].time == Approx(0.35).epsilon(1e-12));
    const table::Table& rows = result.recordings[0].table;
    CHECK(column(rows, "time").back() == result.faults[0].time);
    CHECK(column(rows, "x").back() == Approx(0.35).epsilon(1e-12));
    CHECK(column(rows, "d").back() == Approx(0.7).epsilon(1e-12));
    const auto& times = column(rows, "time");
    const std::ptrdiff_t sides = std::string(record).find("instants") == std::string::npos ? 1 : 2;
    CHECK(std::ranges::count(times, times.back()) == sides);
  }
}

}  // namespace stepwire::run
