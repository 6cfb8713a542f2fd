// Event models with closed forms: located inputs, delays that change, and parts that switch each other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

constexpr double pi = std::numbers::pi;

/// Runs 2 s with located events.
table::Table run_located(const std::string& blocks, const std::string& record, const std::string& step,
                         const std::string& solver = "{name: dormand_prince, relative: 1e-11}") {
  return run_text("step: " + step + "\nstop: 2 s\nsolver: " + solver + "\nevents: locate\nblocks:\n" +
                  blocks + "record: " + record + "\n");
}

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

const char* const steps[] = {"0.1 s", "50 ms", "10 ms"};

}  // namespace

TEST_CASE("an instant arrives through a delay that grows where it is due, and once") {
  // The delay is 0.15 s + 0.2 t, so that what is sent at s arrives at (s + 0.15 s) / 0.8.
  const auto arrival = [](double sent) { return (sent + 0.15) / 0.8; };
  double high = 0.0;
  for (double sent = 0.0; arrival(sent) < 2.0; sent += 0.37)
    high += std::min(arrival(sent + 0.185), 2.0) - arrival(sent);
  const std::pair<const char*, const char*> cases[] = {{"rk4", "hold"},
                                                       {"{name: dormand_prince, relative: 1e-11}", "hold"},
                                                       {"rk4", "smooth"},
                                                       {"{name: dormand_prince, relative: 1e-11}", "linear"}};
  for (const auto& [solver, between] : cases)
    for (const char* step : steps) {
      INFO(step << " " << solver << " " << between);
      const table::Table run = run_located(R"(  delay: {block: Ramp, slope: 0.2, initial: 0.15 s}
  sine: {block: Sine, frequency: 0.3 Hz}
  square: {block: Pulse, period: 0.37 s}
  y: {block: TransportDelay, u: sine, delay: delay, longest: 2 s}
  z: {block: TransportDelay, u: square, delay: delay, longest: 2 s, between: )" +
                                               std::string(between) +
                                               R"(}
  n: {block: Counter, u: z}
  x: {block: Integrator, u: z}
)",
                                           "[y, x, n]", step, solver);
      CHECK(last(run, "y") == Approx(std::sin(0.6 * pi * (0.8 * 2.0 - 0.15))).margin(1e-5));
      CHECK(last(run, "x") == Approx(high).epsilon(1e-9));
      CHECK(last(run, "n") == 4.0);  // sent at 0, 0.37, 0.74 and 1.11 s; the one of 1.48 s arrives at 2.04 s
    }
}

TEST_CASE("a delayed signal has its own shape between jumps, however few samples lie there") {
  // A sawtooth of 1/s that begins again every 0.37 s, and its square. The jumps are between ticks.
  const double left = 2.0 - 0.153 - 4 * 0.37;
  const double once = 0.5 * (4 * 0.37 * 0.37 + left * left);
  const double squared = (4 * 0.37 * 0.37 * 0.37 + left * left * left) / 3.0;
  for (const char* step : steps) {
    INFO(step);
    const table::Table run = run_located(R"(  square: {block: Pulse, period: 0.37 s}
  saw: {block: Integrator, u: 1, reset: square}
  product: {block: Product, u: [saw, saw]}
  y: {block: TransportDelay, u: saw, delay: 0.153 s}
  straight: {block: TransportDelay, u: saw, delay: 0.153 s, between: linear}
  bent: {block: TransportDelay, u: product, delay: 0.153 s}
  a: {block: Integrator, u: y}
  b: {block: Integrator, u: straight}
  c: {block: Integrator, u: bent}
)",
                                         "[a, b, c]", step);
    CHECK(last(run, "a") == Approx(once).epsilon(1e-9));
    CHECK(last(run, "b") == Approx(once).epsilon(1e-9));
    // Two samples at both ends of an interval h give a straight line alone, whose integral is h^3/6 too
    // large.
    CHECK(last(run, "c") == Approx(squared).epsilon(step == std::string("10 ms") ? 1e-6 : 4e-3));
  }
}

TEST_CASE("a delayed jump on a tick has both its sides without located events") {
  // Edges at ticks 2, 4, 6: between two ticks the delayed signal is constant, at whichever time it is read.
  const table::Table run = run_text(R"(step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  u: {block: Pulse, period: 0.4 s}
  y: {block: TransportDelay, u: u, delay: 0.13 s}
  straight: {block: TransportDelay, u: u, delay: 0.13 s, between: linear}
  sum: {block: UnitDelay, u: u}
  z: {block: TransportDelay, u: sum, delay: 0.13 s}
record: [u, y, straight, sum, z]
)");
  for (std::size_t k = 2; k < column(run, "time").size(); ++k) {
    INFO(k);
    CHECK(column(run, "y")[k] == column(run, "u")[k - 2]);
    CHECK(column(run, "straight")[k] == column(run, "u")[k - 2]);
    CHECK(column(run, "z")[k] == column(run, "sum")[k - 2]);
  }
}

TEST_CASE("each step of a quantizer is located, also in a loop") {
  // x' = 1 - q(x): slope 1 up to 0.25, 0.5 up to 0.75 at 1.25 s, then 0. The stair has its steps at
  // 1.7 t = 0.25, 0.75, ..., 3.25, and the value 3.5 at the end.
  double stairs = 0.0;
  for (double at = 0.25; at < 3.4; at += 0.5) stairs += 0.5 * (2.0 - at / 1.7);
  for (const char* step : steps)
    for (const char* solver : {"rk4", "{name: dormand_prince, relative: 1e-11}", "rosenbrock"}) {
      INFO(step << " " << solver);
      const table::Table run = run_located(R"(  ramp: {block: Ramp, slope: 1.7}
  stair: {block: Quantizer, u: ramp, interval: 0.5}
  y: {block: Integrator, u: stair}
  q: {block: Quantizer, u: x, interval: 0.5}
  slope: {block: Sum, u: [1, q], signs: +-}
  x: {block: Integrator, u: slope}
)",
                                           "[y, x]", step, solver);
      CHECK(last(run, "y") == Approx(stairs).epsilon(1e-9));
      CHECK(last(run, "x") == Approx(0.75).epsilon(1e-9));
    }
}

TEST_CASE("a reset on a tick makes its own condition false there") {
  // A sawtooth of 1/s up to 0.5, which ends on ticks. Over 2 s its integral is 4 * 0.5^2 / 2.
  for (const char* condition : {"{block: Compare, u: x.before, operator: greater_equal, to: 0.5}",
                                "{block: Expression, u: x.before, expression: u >= 0.5}",
                                "{block: Relay, u: x.before, switch_on: 0.5, switch_off: 0.001}",
                                "{block: Hysteresis, u: x.before, upper: 0.5, lower: 0.001}"})
    for (const char* step : {"0.5 s", "0.125 s", "0.1 s"})
      for (const char* solver : {"rk4", "sdirk", "rosenbrock", "{name: dormand_prince, relative: 1e-11}"}) {
        INFO(condition << " " << step << " " << solver);
        const table::Table run =
            run_located("  x: {block: Integrator, u: 1 1/s, reset: c}\n  c: " + std::string(condition) +
                            "\n  y: {block: Integrator, u: x}\n",
                        "[x, y]", step, solver);
        CHECK(last(run, "y") == Approx(0.5).epsilon(1e-8));
        CHECK(*std::ranges::max_element(column(run, "x")) < 0.5 + 1e-9);
      }
}

TEST_CASE("truths of a gate and bounds of a map are located") {
  for (const char* step : steps) {
    INFO(step);
    const table::Table run = run_located(R"(  s: {block: Sine, frequency: 0.5 Hz}
  c: {block: Sine, frequency: 0.5 Hz, phase: 90 deg}
  both: {block: Logic, operator: and, u: [s, c]}
  map: {block: Interval, x: s, lower: -0.6, upper: 0.5}
  a: {block: Integrator, u: both}
  b: {block: Integrator, u: map.depth}
)",
                                         "[a, b]", step);
    // Integral of |sin| - 0.5 where it is above, and the same for 0.6.
    const auto beyond = [](double bound) {
      const double from = std::asin(bound);
      return (2.0 * std::cos(from) - bound * (pi - 2.0 * from)) / pi;
    };
    CHECK(last(run, "a") == Approx(0.5).epsilon(1e-9));
    CHECK(last(run, "b") == Approx(beyond(0.5) + beyond(0.6)).epsilon(1e-9));
  }
}

TEST_CASE("a sample, a count and a latch follow the passing of a signal itself") {
  for (const char* step : steps) {
    INFO(step);
    const table::Table run = run_located(R"(  t: {block: Clock}
  s: {block: Sine, frequency: 1.3 Hz}
  high: {block: Sum, u: [s, -0.5]}
  low: {block: Gain, u: high, gain: -1}
  sample: {block: SampleAndHold, u: t, when: s, trigger: falling}
  n: {block: Counter, u: high, count_at: either}
  latch: {block: Latch, set: high, reset: low}
  x: {block: Integrator, u: latch}
)",
                                         "[sample, n, x]", step);
    CHECK(last(run, "sample") == Approx(2.5 / 1.3).epsilon(1e-10));
    CHECK(last(run, "n") == 6.0);  // three periods have their high part before 2 s
    CHECK(last(run, "x") == Approx(3.0 * (pi - 2.0 * std::asin(0.5)) / (2.6 * pi)).epsilon(1e-9));
  }
}

TEST_CASE("the greatest of a sine and a constant bends where they meet") {
  const double meet = std::asin(0.3), period = (2.0 * std::cos(meet) + 0.3 * (pi + 2.0 * meet)) / (2.0 * pi);
  for (const char* step : steps) {
    const table::Table run = run_located(R"(  s: {block: Sine, frequency: 1 Hz}
  most: {block: MinMax, u: [s, 0.3, -2], function: max}
  least: {block: MinMax, u: [low, -0.3], function: min}
  low: {block: Gain, u: s, gain: -1}
  x: {block: Integrator, u: most}
  y: {block: Integrator, u: least}
)",
                                         "[x, y]", step);
    CHECK(last(run, "x") == Approx(2.0 * period).epsilon(1e-9));
    CHECK(last(run, "y") == Approx(-2.0 * period).epsilon(1e-9));
  }
}

TEST_CASE("two thermostats that switch each other keep to their straight lines") {
  // x1 rises by 1 in each second while q2 is on, else it falls; x2 falls by 0.7 while q1 is on, else it
  // rises.
  double x[2] = {0.0, 0.0}, t = 0.0;
  bool q[2] = {false, true};
  while (true) {
    const double v[2] = {q[1] ? 1.0 : -1.0, q[0] ? -0.7 : 0.7};
    double first = 2.0 - t;
    int which = -1;
    for (int i = 0; i < 2; ++i) {
      if (q[i] == (v[i] > 0.0)) continue;  // it moves away from the threshold that would switch it
      const double due = ((v[i] > 0.0 ? 0.13 : -0.11) - x[i]) / v[i];
      if (due >= first) continue;
      first = std::max(due, 0.0);
      which = i;
    }
    for (int i = 0; i < 2; ++i) x[i] += v[i] * first;
    t += first;
    if (which < 0) break;
    q[which] = !q[which];
  }
  for (const char* step : steps) {
    INFO(step);
    const table::Table run = run_located(R"(  q1: {block: Relay, u: x1, switch_on: 0.13, switch_off: -0.11}
  q2: {block: Relay, u: x2, switch_on: 0.13, switch_off: -0.11, initial: 1}
  r1: {block: Expression, u: q2, expression: "u > 0.5 ? 1 : -1"}
  r2: {block: Expression, u: q1, expression: "u > 0.5 ? -0.7 : 0.7"}
  x1: {block: Integrator, u: r1}
  x2: {block: Integrator, u: r2}
)",
                                         "[x1, x2, q1, q2]", step);
    CHECK(last(run, "x1") == Approx(x[0]).margin(1e-9));
    CHECK(last(run, "x2") == Approx(x[1]).margin(1e-9));
    CHECK(last(run, "q1") == (q[0] ? 1.0 : 0.0));
    CHECK(last(run, "q2") == (q[1] ? 1.0 : 0.0));
  }
}

}  // namespace stepwire::run
