#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string head = "step: 1 ms\nstop: 4 s\nsolver: rk4\nblocks:\n";

}  // namespace

// Reference from scipy 1.10.1: plant 1 / (s^2 + s + 1), controller C = 3 + 2/s + s/(0.05 s + 1).
// Call: signal.step((num C, den C den plant + num C), T=linspace(0, 4, 4001)), at 0.5, 1, 2, 4 s
TEST_CASE("A loop closed by a PID controller agrees with SciPy") {
  const table::Table table = run_text(head + R"(  e: {block: Sum, signs: "+-", u: [1, plant]}
  pid: {block: PID, kp: 3, ki: 2, kd: 1, tau: 50 ms, settled: false, u: e}
  plant: {block: TransferFunction, numerator: [1], denominator: [1, 1, 1], u: pid}
record: [plant]
)");
  const auto& y = column(table, "plant");
  CHECK(y[500] == Approx(0.5550656490133479).epsilon(1e-8));
  CHECK(y[1000] == Approx(0.9974239957079603).epsilon(1e-8));
  CHECK(y[2000] == Approx(1.082980784469895).epsilon(1e-8));
  CHECK(y[4000] == Approx(0.9434948343010551).epsilon(1e-8));
}

TEST_CASE(
    "The derivative part of a controller is 0 at the start and behind a reset, and shows a later jump") {
  const auto run = [](const std::string& keys) {
    return column(run_text(head + R"(  e: {block: Step, time: 2, before: 5, after: 6}
  back: {block: Step, time: 3}
  pid: {block: PID, kp: 1, kd: 4, tau: 100 ms, u: e)" +
                           keys + "}\nrecord: [pid]\n"),
                  "pid");
  };
  const auto plain = run(""), reset = run(", reset: back"), kick = run(", reset: back, settled: false");
  CHECK(kick[0] == Approx(5.0 + 4.0 * 5.0 / 0.1));
  CHECK(kick[3000] == Approx(6.0 + 4.0 * 6.0 / 0.1));
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const double since = 1e-3 * static_cast<double>(k) - 2.0;
    const double pulse = k < 2000 ? 0.0 : 40.0 * std::exp(-since / 0.1);
    CHECK(plain[k] == Approx((k < 2000 ? 5.0 : 6.0) + pulse).epsilon(1e-7));
    CHECK(reset[k] == Approx((k < 2000 ? 5.0 : 6.0) + (k < 3000 ? pulse : 0.0)).epsilon(1e-7));
  }
}

TEST_CASE("Of a ramp, the parts of a PID controller are ramp, parabola and filtered step") {
  const table::Table table = run_text(head + R"(  e: {block: Ramp, slope: 2}
  pid: {block: PID, kp: 3, ki: 0.5, kd: 4, tau: 100 ms, u: e, initial: 10}
record: [pid]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50) {
    const double t = time[k];
    const double expected = 6.0 * t + 10.0 + 0.5 * t * t + 8.0 * (1.0 - std::exp(-t / 0.1));
    CHECK(column(table, "pid")[k] == Approx(expected).epsilon(1e-9));
  }
}

namespace {

/// The error is 1 for 2 s and -1 from then on; kp = 1, ki = 2, so the output reaches its limit of 2 at 0.5 s.
std::vector<double> integral_of(const std::string& anti_windup) {
  const table::Table table = run_text(head + R"(  e: {block: Step, time: 2, before: 1, after: -1, every: 1 ms}
  pid: {block: PID, kp: 1, ki: 2, upper: 2, u: e, anti_windup: )" +
                                      anti_windup + "}\nrecord: [pid, pid.integral]\n");
  for (double y : column(table, "pid")) CHECK(y <= 2.0);
  return column(table, "pid.integral");
}

}  // namespace

TEST_CASE("Without anti-windup the integral part goes on while the output is at its limit") {
  const auto integral = integral_of("none");
  CHECK(integral[2000] == Approx(4.0));
  CHECK(integral[4000] == Approx(0.0).margin(1e-9));
}

TEST_CASE("Clamping stops the integral part at the limit and lets it leave at once") {
  const auto integral = integral_of("clamping");
  CHECK(integral[500] == Approx(1.0).margin(1e-3));
  CHECK(integral[2000] == Approx(1.0).margin(2.1e-3));  // to a step of 1 ms
  CHECK(integral[2500] == Approx(integral[2000] - 1.0).margin(1e-9));
}

TEST_CASE("Limits of a PID are located") {
  // The integral part is clamped at 0.2, from t = 0.25 s on, and leaves at 1.03 s with the slope -1.
  const std::string located =
      "events: locate\nstep: 100 ms\nstop: 1.5 s\nblocks:\n"
      "  s: {block: Step, time: 1.03 s, before: 0.8, after: -1}\n";
  for (const char* solver : {"euler", "rk4", "dormand_prince"}) {
    INFO(solver);
    const table::Table run = run_text(std::string("solver: ") + solver + "\n" + located +
                                      "  p: {block: PID, u: s, kp: 0.125, ki: 1, upper: 0.3}\n"
                                      "  q: {block: PID, u: s, kp: 0, ki: 1, integral_upper: 0.2}\n"
                                      "record: [p, p.integral, q]\n");
    CHECK(column(run, "p").back() == Approx(-0.125 + 0.2 - 0.47).margin(1e-9));
    CHECK(column(run, "q").back() == Approx(0.2 - 0.47).margin(1e-9));
  }
}

TEST_CASE("A located PID slides along its limit where its parts pull in opposite directions") {
  // u falls by 0.1/s. Above the limit the command falls with kp u, below it rises with ki u: it stays there.
  const table::Table run = run_text(
      "events: locate\nstep: 10 ms\nstop: 2 s\nsolver: rk4\nblocks:\n  u: {block: Ramp, slope: -0.1, "
      "initial: 1}\n"
      "  p: {block: PID, u: u, kp: 1, ki: 1, upper: 1.25}\nrecord: [p, p.integral, u]\n");
  for (std::size_t k = 40; k < run.rows(); ++k) {
    CHECK(column(run, "p")[k] == Approx(1.25).margin(0.01));
    CHECK(column(run, "p.integral")[k] + column(run, "u")[k] == Approx(1.25).margin(0.01));
  }
}

TEST_CASE("Back calculation settles where what comes in is what is taken away") {
  // di/dt = 2 + (2 - 1 - i) / 0.25 from i = 1 at 0.5 s on: i = 1.5 - 0.5 exp(-(t - 0.5) / 0.25)
  const auto integral = integral_of("back_calculation, tracking: 250 ms");
  CHECK(integral[500] == Approx(1.0));
  CHECK(integral[750] == Approx(1.5 - 0.5 * std::exp(-1.0)).epsilon(1e-5));
  CHECK(integral[2000] == Approx(1.5 - 0.5 * std::exp(-6.0)).epsilon(1e-5));
}

TEST_CASE("The integral part has limits of its own") {
  const table::Table table = run_text(head + R"(  e: {block: Step, time: 2, before: 1, after: -1, every: 1 ms}
  pid: {block: PID, kp: 1, ki: 2, u: e, integral_lower: -0.5, integral_upper: 0.25}
record: [pid]
)");
  const auto& y = column(table, "pid");
  CHECK(y[100] == Approx(1.2));
  CHECK(y[1500] == Approx(1.25));
  CHECK(y[2100] == Approx(-1.0 + 0.25 - 0.2));
  CHECK(y[4000] == Approx(-1.5));
}

TEST_CASE("Weights let the proportional and derivative parts see less of the reference") {
  const table::Table table = run_text(head + R"(  r: {block: Constant, value: 2}
  m: {block: Ramp, slope: 1}
  e: {block: Sum, signs: "+-", u: [r, m]}
  pid: {block: PID, kp: 3, kd: 5, tau: 100 ms, weight_p: 0.25, weight_d: 0, u: e, reference: r}
record: [pid]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50) {
    const double t = time[k];
    CHECK(column(table, "pid")[k] == Approx(3.0 * (0.5 - t) - 5.0 * (1.0 - std::exp(-t / 0.1))).margin(1e-9));
  }
  CHECK_THAT(error_of(head + "  pid: {block: PID, weight_d: 0, u: 1}\n"),
             Catch::Contains("'reference' is missing"));
}

TEST_CASE("The integral part leaves a limit at its instant with every solver") {
  const std::string solver =
      GENERATE("heun", "bogacki_shampine", "rk4", "dormand_prince", "rosenbrock", "sdirk", "rodas");
  INFO(solver);
  const auto end_of = [&](const std::string& blocks) {
    const table::Table run = run_text("events: locate\nstep: 100 ms\nstop: 1 s\nsolver: " + solver +
                                      "\nblocks:\n" + blocks + "record: [p.integral]\n");
    return column(run, "p.integral").back();
  };
  // Clamped until 3 (1 - t) = 1.1589, at 0.6137 s; then the integral of 1 - t.
  CHECK(end_of("  e: {block: Ramp, slope: -1, initial: 1}\n"
               "  p: {block: PID, u: e, kp: 3, ki: 1, upper: 1.1589}\n") ==
        Approx(0.5 * 0.3863 * 0.3863).epsilon(1e-9));
  // At the limit of 0.21 until the error 1.0874 - 2 t turns at 0.5437 s; then 0.21 - (t - 0.5437)^2.
  CHECK(end_of("  e: {block: Ramp, slope: -2, initial: 1.0874}\n"
               "  p: {block: PID, u: e, kp: 0, ki: 1, integral_upper: 0.21, anti_windup: none}\n") ==
        Approx(0.21 - 0.4563 * 0.4563).epsilon(1e-9));
}
