// PID and DiscretePID with an actuator that deviates from the command, and in manual mode.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The integral part follows what the actuator does, with the time constant of tracking") {
  // e = 1, ki = 2, kp = 0: di/dt = 2 + (0.5 - i) / 0.1 goes to 0.5 + 0.2.
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  half: {block: Constant, value: 0.5}
  c: {block: PID, u: 1, kp: 0, ki: 2, actual: half, tracking: 0.1 s, anti_windup: none}
  d: {block: DiscretePID, u: 1, kp: 0, ki: 2, actual: half, tracking: 0.1 s, anti_windup: none, every: 1 ms}
record: [c, d]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50) {
    CHECK(column(table, "c")[k] == Approx(0.7 * (1.0 - std::exp(-time[k] / 0.1))).epsilon(1e-9));
    CHECK(column(table, "d")[k] ==
          Approx(0.7 * (1.0 - std::pow(0.99, static_cast<double>(k)))).epsilon(1e-9));
  }
}

TEST_CASE("A loop whose actuator saturates behind its controller does not wind up where it is followed") {
  const auto overshoot = [](const std::string& actual) {
    const table::Table table = run_text(fmt::format(R"(
step: 1 ms
stop: 20 s
solver: rk4
blocks:
  e: {{block: Sum, signs: "+-", u: [1, x]}}
  c: {{block: PID, u: e, kp: 1, ki: 2{}}}
  motor: {{block: Saturation, u: c, lower: -0.2, upper: 0.2}}
  x: {{block: Integrator, u: motor}}
record: [x]
)",
                                                    actual));
    const auto& x = column(table, "x");
    return *std::max_element(x.begin(), x.end()) - 1.0;
  };
  CHECK(overshoot("") > 0.8);
  CHECK(overshoot(", actual: motor, tracking: 0.5 s") < 0.1);
}

TEST_CASE("By hand the command is manual, and the controller goes on from there without a bump") {
  for (const char* const kind : {"PID", "DiscretePID"}) {
    const table::Table table = run_text(fmt::format(R"(
step: 1 ms
stop: 3 s
solver: rk4
blocks:
  e: {{block: Sine, frequency: 0.2 Hz, every: 1 ms}}
  lever: {{block: Constant, value: 4}}
  auto: {{block: Pulse, period: 10 s, width: 0.1, delay: 1 s}}
  c: {{block: {}, u: e, kp: 2, ki: 0.5, kd: 0.1, tau: 0.05, manual: lever, automatic: auto, upper: 5}}
record: [c]
)",
                                                    kind));
    INFO(kind);
    const auto& y = column(table, "c");
    for (std::size_t k = 0; k < 1000; ++k) CHECK(y[k] == 4.0);
    // The error moves by at most 0.00126 a tick: what the command makes of that is all that changes.
    CHECK(std::abs(y[1000] - 4.0) < 0.005);
    CHECK(std::abs(y[1001] - y[1000]) < 0.005);
    CHECK(y[1500] != 4.0);
    CHECK(y[2500] == 4.0);
  }
}

TEST_CASE("a sampled controller begins at the command by hand, however fast its error moves") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 3 s
blocks:
  e: {block: Ramp, slope: 7}
  auto: {block: Pulse, period: 10 s, width: 0.2, delay: 1 s}
  c: {block: DiscretePID, every: 10 ms, u: e, kp: 2, manual: 4, automatic: auto}
record: [c]
)");
  const auto& y = column(table, "c");
  for (std::size_t k = 0; k <= 200; ++k)
    CHECK(y[k] == Approx(k < 100 ? 4.0 : 4.0 + 2.0 * 0.07 * static_cast<double>(k - 100)));
}

TEST_CASE("manual and automatic belong together") {
  CHECK(error_of("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  m: {block: Constant, value: 1}\n"
                 "  c: {block: PID, u: 1, manual: m}\nrecord: [c]\n")
            .find("automatic") != std::string::npos);
}

TEST_CASE("The hand-over between two ticks has no bump") {
  // By hand until 0.5437 s, then 0.2 + 3 (e(t) - e(0.5437 s)) with e = 1 - t.
  const table::Table run = run_text(
      "events: locate\nstep: 100 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
      "  e: {block: Ramp, slope: -1, initial: 1}\n  auto: {block: Step, time: 0.5437 s}\n"
      "  c: {block: PID, u: e, kp: 3, ki: 0, manual: 0.2, automatic: auto}\nrecord: [c]\n");
  CHECK(column(run, "c")[5] == Approx(0.2));
  CHECK(column(run, "c")[6] == Approx(0.2 - 3.0 * (0.6 - 0.5437)));
  CHECK(column(run, "c").back() == Approx(0.2 - 3.0 * (1.0 - 0.5437)));
}
