// Rows just before and just after what happens.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::record {

namespace {

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("an edge on a tick has a row with the value before it and one with that after it") {
  const table::Table run = run_text(R"(blocks:
  edge: {block: Step, time: 1 s}
  x: {block: Integrator, u: edge}
  held: {block: Gain, gain: 1, u: x, every: 1 s}
solver: rk4
step: 1 s
stop: 2 s
record: {instants: true, signals: [edge, x, held]}
)");
  CHECK(column(run, "time") == Numbers{0, 1, 1, 2, 2});
  CHECK(column(run, "edge") == Numbers{0, 0, 1, 1, 1});
  CHECK_THAT(column(run, "x"), Catch::Approx(Numbers{0, 0, 0, 1, 1}).margin(1e-12));
  CHECK_THAT(column(run, "held"), Catch::Approx(Numbers{0, 0, 0, 0, 1}).margin(1e-12));
}

TEST_CASE("a state that is reset at a located crossing has both of its values there") {
  for (const char* solver : {"rk4", "rosenbrock", "{name: dormand_prince, relative: 1e-9}"}) {
    INFO(solver);
    const table::Table run = run_text(std::string("solver: ") + solver + R"(
blocks:
  x: {block: Integrator, u: 1, reset: full, value: 0}
  full: {block: Compare, u: x.before, operator: greater_equal, to: 0.7}
  double: {block: Gain, gain: 2, u: x}
events: locate
step: 1 s
stop: 1 s
record: {instants: true, signals: [x, double]}
)");
    const Numbers &time = column(run, "time"), &x = column(run, "x"), &twice = column(run, "double");
    REQUIRE(time.size() == 5);
    CHECK(time[1] == Approx(0.7).epsilon(1e-11));
    CHECK(time[1] == time[2]);
    CHECK(x[1] == Approx(0.7).epsilon(1e-11));
    CHECK(x[2] == 0.0);
    CHECK(twice[1] == Approx(1.4).epsilon(1e-11));
    CHECK(twice[2] == 0.0);
    CHECK(x[3] == Approx(0.3).epsilon(1e-9));
    CHECK(x[3] == x[4]);
  }
}

TEST_CASE("a run that ends at an event ends with its two rows") {
  const table::Table run = run_text(R"(blocks:
  x: {block: Integrator, u: 1}
solver: rk4
events: locate
step: 1 s
stop: 3 s
stop_when: x > 1.25
record: {instants: true, signals: x}
)");
  const Numbers& time = column(run, "time");
  REQUIRE(time.size() == 5);
  CHECK(time[3] == Approx(1.25).epsilon(1e-11));
  CHECK(time[3] == time[4]);
}

TEST_CASE("a run keeps its bits where both sides are recorded") {
  const std::string text = R"yaml(blocks:
  u: {block: Sine, frequency: 0.7 Hz}
  loop: {block: Expression, variables: [u, x, v], u: [u, x, back], expression: "u - x - 0.3*tanh(v)"}
  back: {block: Gain, gain: 2, u: loop}
  x: {block: Integrator, u: loop, reset: low, value: 0.1}
  low: {block: Compare, u: x.before, operator: less, to: -0.05}
  shown: {block: Gain, gain: 3, u: x}
algebraic_loops: solve
solver: rk4
step: 10 ms
stop: 3 s
)yaml";
  for (const char* events : {"events: tick\n", "events: locate\n"}) {
    INFO(events);
    const run::RunResult alone = result_of(text + events + "record: [x, loop, shown]\n"),
                         both =
                             result_of(text + events +
                                       "record: [x, loop, shown, {instants: true, signals: [x, shown]}]\n");
    REQUIRE(both.recordings.size() == 2);
    REQUIRE(column(both.recordings[1].table, "time").size() > 600);
    for (const char* name : {"x", "loop", "shown"}) {
      const Numbers &a = column(alone.recordings[0].table, name), &b = column(both.recordings[0].table, name);
      REQUIRE(a.size() == b.size());
      CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
    }
  }
}

TEST_CASE("rows of both sides that are behind a kept moment are taken back") {
  const plan::Plan plan =
      plan_text("blocks:\n  t: {block: Clock}\nstop: 5 s\nrecord: {instants: true, signals: t}\n");
  RunRecording recording(plan);
  Recorder& recorder = recording.recorders().front();
  Numbers values(plan.layout.size, 0.0);
  const auto row = [&](double time, Recorder::Side side) {
    values[plan::Layout::time] = time;
    recorder.record_side(values.data(), side);
  };
  row(0.0, Recorder::Side::after);
  for (const double time : {1.0, 1.5, 2.0}) {
    row(time, Recorder::Side::before);
    row(time, Recorder::Side::after);
  }
  recorder.go_back_to(2);
  CHECK(recorder.rows() == 6);
  recorder.go_back_to(1);
  row(1.0, Recorder::Side::after);
  CHECK(column(recording.finished().front().table, "time") == Numbers{0, 1, 1});
  recording.restart();
  CHECK(recorder.rows() == 0);
}

TEST_CASE("both sides are refused beside a period, and with several runs") {
  const auto faults = faults_of(R"(parameters: {k: 1}
blocks:
  x: {block: Constant, value: $k}
sweep: {k: [1, 2]}
record: {instants: true, every: 1 s, signals: x}
)");
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Catch::Contains("leave 'every' out"));
  CHECK_THAT(faults[1], Catch::Contains("belongs to a single run") && Catch::Contains("'sweep'"));
}

}  // namespace stepwire::record
