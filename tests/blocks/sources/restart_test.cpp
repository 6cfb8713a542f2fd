// Sources that begin anew where a condition makes them active.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire {

namespace {

/// A source that is active from 0.137 s to 0.5 s and from 0.737 s on, and its integral.
table::Table gated(const std::string& source, const std::string& events,
                   const std::string& states = "reset") {
  return run_text("events: " + events + R"(
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  gate: {block: Pulse, period: 0.6 s, width: 0.605, delay: 0.137 s}
  y: {block: )" + source +
                  ", enable: {when: gate, outputs: reset, states: " + states + R"(}}
  x: {block: Integrator, u: y}
record: [y, x]
)");
}

double last(const table::Table& run) {
  return column(run, "x").back();
}

}  // namespace

TEST_CASE("with restart a source begins anew at the instant at which it becomes active") {
  const auto end = [](const std::string& source) {
    return last(gated(source + ", restart: true", "locate"));
  };
  const double first = 0.363, second = 0.263, turn = 2.0 * M_PI;  // how long it is active
  CHECK(end("Ramp, slope: 2") == Approx(first * first + second * second).epsilon(1e-11));
  CHECK(end("Ramp, slope: 2, start: 0.2 s") == Approx(0.163 * 0.163 + 0.063 * 0.063).epsilon(1e-11));
  CHECK(end("Clock") == Approx(0.5 * (first * first + second * second)).epsilon(1e-11));
  CHECK(end("Step, time: 0.1 s, after: 3") == Approx(3.0 * (0.263 + 0.163)).epsilon(1e-11));
  CHECK(end("Pulse, period: 0.2 s, width: 0.25, phase: 90 deg") ==
        Approx(0.113).margin(1e-11));  // 50 ms and 13 ms, and 50 ms
  CHECK(end("Sine, frequency: 1 Hz") ==
        Approx((2.0 - std::cos(turn * first) - std::cos(turn * second)) / turn).epsilon(1e-7));
  CHECK(end("Chirp, frequency: 1 Hz, target_frequency: 1 Hz, phase: 90 deg") ==
        Approx((std::sin(turn * first) + std::sin(turn * second)) / turn).epsilon(1e-7));
  CHECK(end("Multisine, frequencies: [1 Hz], phase: zero") ==
        Approx((std::sin(turn * first) + std::sin(turn * second)) / turn).epsilon(1e-7));
}

TEST_CASE("at ticks a source with restart begins anew at the first tick at which it is active") {
  const auto y = column(gated("Ramp, slope: 2, restart: true", "tick"), "y");
  CHECK(y[13] == 0.0);
  for (std::size_t k = 14; k < 50; ++k)
    CHECK(y[k] == Approx(0.02 * static_cast<double>(k - 14)).margin(1e-12));
  for (std::size_t k = 74; k <= 100; ++k)
    CHECK(y[k] == Approx(0.02 * static_cast<double>(k - 74)).margin(1e-12));
}

TEST_CASE("without restart a source follows the time of the run, and where states are held it goes on") {
  for (const char* states : {"reset", "held"}) {
    const auto y = column(gated("Ramp, slope: 2", "tick", states), "y");
    for (std::size_t k = 74; k <= 100; ++k) CHECK(y[k] == Approx(0.02 * static_cast<double>(k)));
  }
  const auto held = column(gated("Ramp, slope: 2, restart: true", "tick", "held"), "y");
  for (std::size_t k = 74; k <= 100; ++k) CHECK(held[k] == Approx(0.02 * static_cast<double>(k - 14)));
}

TEST_CASE("a source that nothing switches gives the same bits with restart") {
  for (const char* source :
       {"Ramp, slope: 2, start: 0.3 s", "Sine, frequency: 3 Hz", "Pulse, period: 70 ms"}) {
    const auto run = [&](const std::string& keys) {
      return column(run_text("step: 1 ms\nstop: 1 s\nblocks:\n  y: {block: " + std::string(source) + keys +
                             "}\nrecord: [y]\n"),
                    "y");
    };
    CHECK(run("") == run(", restart: true"));
  }
}

}  // namespace stepwire
