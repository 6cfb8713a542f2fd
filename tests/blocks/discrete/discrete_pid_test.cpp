#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The controller of a written loop is expressed to the last bit") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
blocks:
  e: {block: Sine, amplitude: 3, frequency: 1.3, phase: 0.4, bias: 0.3, every: 1 ms}
  pid: {block: DiscretePID, kp: 0.005, ki: 0.5, kd: 1e-5, integral_lower: 0, integral_upper: 0.35, u: e,
        settled: false}
record: [e, pid]
)");
  double integral = 0.0, before = 0.0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double e = column(table, "e")[k];
    CHECK(column(table, "pid")[k] == 0.005 * e + integral + 1e-5 * ((e - before) / 0.001));
    integral = std::clamp(integral + 0.5 * 0.001 * e, 0.0, 0.35);
    before = e;
  }
}

namespace {

const std::string head = "step: 10 ms\nstop: 4 s\nblocks:\n";

std::vector<double> integral_of(const std::string& keys) {
  const table::Table table = run_text(head + R"(  e: {block: Step, time: 1.995, before: 1, after: -1}
  pid: {block: DiscretePID, kp: 1, ki: 2, upper: 2, u: e, )" +
                                      keys + "}\nrecord: [pid, pid.integral]\n");
  for (double y : column(table, "pid")) CHECK(y <= 2.0);
  return column(table, "pid.integral");
}

}  // namespace

TEST_CASE("The filtered difference is the backward difference of the filter's equation") {
  const table::Table table = run_text(head + R"(  e: {block: Ramp, slope: 3}
  pid: {block: DiscretePID, kp: 0, kd: 2, tau: 40 ms, u: e}
record: [pid]
)");
  for (std::size_t k = 0; k < 100; ++k)  // pole at tau / (tau + T) = 0.8
    CHECK(column(table, "pid")[k] ==
          Approx(6.0 * (1.0 - std::pow(0.8, static_cast<double>(k)))).margin(1e-12));
}

TEST_CASE("The integral part sums before, after or around the output, as its method says") {
  const auto output = [](const std::string& method) {
    return column(run_text(head + "  pid: {block: DiscretePID, kp: 0, ki: 2, u: 1, method: " + method +
                           "}\nrecord: [pid]\n"),
                  "pid");
  };
  const auto forward = output("forward_euler"), backward = output("backward_euler"),
             middle = output("trapezoidal");
  for (std::size_t k = 0; k < forward.size(); ++k) {
    const double n = static_cast<double>(k);
    CHECK(forward[k] == Approx(0.02 * n).margin(1e-12));
    CHECK(backward[k] == Approx(0.02 * (n + 1.0)).margin(1e-12));
    CHECK(middle[k] == Approx(0.02 * (n + 0.5)).margin(1e-12));
  }
}

TEST_CASE("Discrete anti-windup goes on, stops, or follows the output") {
  CHECK(integral_of("anti_windup: none")[200] == Approx(4.0));
  for (const std::string method : {"forward_euler", "backward_euler", "trapezoidal"}) {
    const auto clamped = integral_of("anti_windup: clamping, method: " + method);
    CHECK(clamped[199] == Approx(1.0).margin(0.0201));
    CHECK(clamped[250] == Approx(clamped[199] - 1.0).margin(0.0601));
  }
  // i[k+1] = i[k] + 0.02 + 0.04 (1 - i[k]) settles at 1.5
  const auto back = integral_of("anti_windup: back_calculation, tracking: 250 ms");
  CHECK(back[199] == Approx(1.5).epsilon(2e-3));
  CHECK(back[60] == Approx(1.5 - 0.5 * std::pow(0.96, 10.0)).epsilon(1e-9));
}

TEST_CASE("A weight of 0 keeps a step of the reference out of the difference") {
  const table::Table table = run_text(head + R"(  r: {block: Step, time: 1, after: 5}
  pid: {block: DiscretePID, kp: 0, kd: 1, weight_d: 0, u: r, reference: r}
record: [pid]
)");
  for (double y : column(table, "pid")) CHECK(y == 0.0);
}

TEST_CASE("D is 0 at the first tick and at a reset, and shows a jump that comes later") {
  const auto run = [](const std::string& keys) {
    return column(run_text(head + R"(  e: {block: Step, time: 2, before: 5, after: 6}
  back: {block: Step, time: 3}
  pid: {block: DiscretePID, kp: 1, kd: 4, tau: 90 ms, u: e, reset: back)" +
                           keys + "}\nrecord: [pid]\n"),
                  "pid");
  };
  const auto y = run(""), kick = run(", settled: false");
  CHECK(kick[0] == Approx(5.0 + 4.0 * 5.0 / 0.1));
  CHECK(kick[300] == Approx(6.0 + 4.0 * 6.0 / 0.1));
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double pulse = k < 200 || k >= 300 ? 0.0 : 40.0 * std::pow(0.9, static_cast<double>(k) - 200.0);
    CHECK(y[k] == Approx((k < 200 ? 5.0 : 6.0) + pulse).epsilon(1e-9));
  }
}
