// y(t) = u(t - delay), against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/register.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire {
using Catch::Matchers::Contains;

namespace {

/// x' = -x(t - 1) with x = 1 before 0, by the method of steps.
double by_steps(double t) {
  double sum = 0.0, factorial = 1.0;
  for (int k = 0; t - k + 1.0 >= 0.0; ++k) {
    if (k > 0) factorial *= k;
    sum += std::pow(-1.0, k) * std::pow(t - k + 1.0, k) / factorial;
  }
  return sum;
}

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

double error_by_steps(const std::string& solver, double step) {
  const table::Table run = run_text("step: " + std::to_string(step) + " s\nstop: 6 s\nsolver: " + solver + R"(
blocks:
  x: {block: Integrator, u: minus, initial: 1}
  minus: {block: Gain, gain: -1, u: past}
  past: {block: TransportDelay, u: x, delay: 1 s, initial: 1}
record: [x]
)");
  double worst = 0.0;
  for (std::size_t k = 0; k < column(run, "time").size(); ++k)
    worst = std::max(worst, std::abs(column(run, "x")[k] - by_steps(column(run, "time")[k])));
  return worst;
}

}  // namespace

TEST_CASE("an equation with a delay has its closed form, with the solver's order") {
  const table::Table run = run_text(R"(step: 10 ms
stop: 2 s
solver: rk4
blocks:
  x: {block: Integrator, u: minus, initial: 1}
  minus: {block: Gain, gain: -1, u: past}
  past: {block: TransportDelay, u: x, delay: 1 s, initial: 1}
record: [x]
)");
  CHECK(last(run, "x") == Approx(-0.5).epsilon(1e-12));
  const std::pair<const char*, double> orders[] = {{"heun", 2.0}, {"bogacki_shampine", 3.0}, {"rk4", 4.0}};
  for (const auto& [solver, order] : orders) {
    INFO(solver);
    const double coarse = error_by_steps(solver, 0.05), fine = error_by_steps(solver, 0.025);
    CHECK(std::log2(coarse / fine) > order - 0.4);
  }
  // Its errors are smaller, so its steps are longer.
  CHECK(std::log2(error_by_steps("dormand_prince", 0.1) / error_by_steps("dormand_prince", 0.05)) > 4.6);
}

TEST_CASE("a smooth signal is delayed by any time, to the fifth order of the step") {
  const auto worst = [](const std::string& step) {
    const table::Table run = run_text("step: " + step + "\nstop: 1 s\nsolver: rk4\n" + R"(blocks:
  u: {block: Sine, frequency: 1 Hz}
  y: {block: TransportDelay, u: u, delay: 126.66666666666667 ms}
record: [y]
)");  // a third of both steps away from a sample
    double error = 0.0;
    for (std::size_t k = 0; k < column(run, "time").size(); ++k) {
      const double t = column(run, "time")[k] - 0.12666666666666667;
      if (t > 0.2) error = std::max(error, std::abs(column(run, "y")[k] - std::sin(2.0 * M_PI * t)));
    }
    return error;
  };
  const double coarse = worst("20 ms"), fine = worst("10 ms");
  CHECK(fine < 1e-7);
  CHECK(coarse / fine > 25.0);
}

TEST_CASE("a delayed jump is an instant where events are located") {
  const table::Table run = run_text(R"(events: locate
step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  u: {block: Step, time: 0.2 s}
  between: {block: Step, time: 0.33 s}
  y: {block: TransportDelay, u: u, delay: 0.153 s}
  z: {block: TransportDelay, u: between, delay: 0.2 s}
  ys: {block: Integrator, u: y}
  zs: {block: Integrator, u: z}
record: [ys, zs]
)");
  CHECK(last(run, "ys") == Approx(1.0 - 0.353).epsilon(1e-9));
  CHECK(last(run, "zs") == Approx(1.0 - 0.53).epsilon(1e-9));
}

TEST_CASE("a jump on a tick is no slope of the step before it") {
  // A delay of whole steps moves the samples as they are.
  const table::Table run = run_text(R"(step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  u: {block: Step, time: 0.3 s}
  y: {block: TransportDelay, u: u, delay: 0.2 s}
  ys: {block: Integrator, u: y}
record: [y, ys]
)");
  CHECK(last(run, "ys") == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a delay may be a signal: a ramp that is delayed by a ramp is straight") {
  const table::Table run = run_text(R"(step: 10 ms
stop: 2 s
solver: rk4
blocks:
  t: {block: Clock}
  by: {block: Expression, u: t, expression: "0.1 + 0.25*u"}
  y: {block: TransportDelay, u: t, delay: by, longest: 1 s}
record: [y]
)");
  CHECK(last(run, "y") == Approx(2.0 - 0.6).epsilon(1e-12));
}

TEST_CASE("a delay with ticks of its own keeps the left side of these ticks, also beside a guard") {
  // A ramp has no jump at any tick. The delay of 0.1 s is between two and three samples.
  const std::string guard = "  beside: {block: Gain, u: t, enable: {when: \"t > 0.05\", states: held}}\n";
  for (const std::string& more : {std::string(), guard})
    for (const std::string events : {"tick", "locate"}) {
      INFO(more << events);
      const table::Table run = run_text("step: 10 ms\nstop: 0.4 s\nevents: " + events + R"(
blocks:
  t: {block: Clock}
  u: {block: Gain, u: t, gain: 3}
  y: {block: TransportDelay, u: u, delay: 0.1 s, every: 40 ms}
)" + more + "record: [y, all]\n");
      CHECK(last(run, "y") == Approx(3.0 * (0.4 - 0.1)).epsilon(1e-12));
    }
}

TEST_CASE("a delay that cannot be kept is refused, or ends the run") {
  const auto of = [](const std::string& delay) {
    return error_of(
        "step: 10 ms\nstop: 2 s\nsolver: rk4\nblocks:\n  t: {block: Clock}\n  y: {block: TransportDelay, u: "
        "t, " +
        delay + "}\n");
  };
  CHECK_THAT(of("delay: 5 ms"), Contains("is less than the step of 0.01 s"));
  CHECK_THAT(of("delay: t"), Contains("below a step or above `longest`"));
  CHECK_THAT(of("delay: -1 s"), Contains("is less than the step"));
  CHECK(of("delay: 10 ms").empty());
}

TEST_CASE("behind a jump that comes around the loop the past bends at a tick, and keeps the solver's order") {
  // x' = -x(t - 1) with 3 before 0, and 1 at 0: 1 - 3 t, -2 - s + 3 s^2/2, then the integral of that.
  const auto error = [](const std::string& solver, double step) {
    const table::Table run =
        run_text("step: " + std::to_string(step) + " s\nstop: 3 s\nsolver: " + solver + R"(
blocks:
  x: {block: Integrator, u: minus, initial: 1}
  minus: {block: Gain, gain: -1, u: past}
  past: {block: TransportDelay, u: x, delay: 1 s, initial: 3}
record: [x]
)");
    return std::abs(last(run, "x") - (-1.5 + 2.0 + 0.5 - 0.5));
  };
  for (const std::string solver : {"heun", "bogacki_shampine", "rk4", "dormand_prince", "sdirk"}) {
    INFO(solver);
    CHECK(error(solver, 0.1) < (solver == "heun" ? 3e-3 : 1e-9));
    CHECK(error(solver, 0.05) < (solver == "heun" ? 8e-4 : 1e-9));
  }
}

TEST_CASE("a fresh edge is carried, though an echo of an earlier one arrives at its instant") {
  // The steps of the second derivative follow each other by the delay. x is (t - k T)^2/2 for each, delayed
  // by T, and z its integral.
  constexpr double delay = 10.3e-3;
  for (int edges = 1; edges <= 7; ++edges) {
    std::string text = "events: locate\nstep: 1 ms\nstop: 0.1 s\nsolver: rk4\nblocks:\n", all;
    for (int k = 1; k <= edges; ++k) {
      const std::string name = "s" + std::to_string(k);
      text += "  " + name + ": {block: Step, time: " + std::to_string(k * 10.3) + " ms}\n";
      all += (k > 1 ? ", " : "") + name;
    }
    const table::Table run = run_text(text + "  a: {block: Sum, u: [" + all + R"(]}
  v: {block: Integrator, u: a}
  x: {block: Integrator, u: v}
  y: {block: TransportDelay, u: x, delay: 10.3 ms}
  z: {block: Integrator, u: y}
record: [z]
)");
    double right = 0.0;
    for (int k = 1; k <= edges; ++k) right += std::pow(0.1 - (k + 1) * delay, 3) / 6.0;
    INFO(edges);
    CHECK(last(run, "z") == Approx(right).margin(1e-17).epsilon(1e-11));
  }
}

TEST_CASE(
    "the past of a loop ends at its known bends, so a jump that returns off the ticks keeps the order") {
  // x' = -63.94 x(t - 6.502 ms) with -0.345 before 0 and -0.2586 at 0, by the method of steps.
  constexpr double delay = 6.502e-3, gain = -63.94;
  const auto exact = [&](double t) {
    std::vector<double> piece{-0.345};
    double begin = -0.2586, value = 0.0;
    for (int k = 0; k * delay <= t; ++k) {
      std::vector<double> next{begin};
      for (std::size_t n = 0; n < piece.size(); ++n)
        next.push_back(gain * piece[n] / static_cast<double>(n + 1));
      piece = next;
      const auto at = [&](double s) {
        double sum = 0.0;
        for (std::size_t n = piece.size(); n-- > 0;) sum = sum * s + piece[n];
        return sum;
      };
      begin = at(delay);
      value = at(t - k * delay);
    }
    return value;
  };
  const table::Table run = run_text(R"(events: locate
step: 0.25 ms
stop: 32 ms
solver: rk4
blocks:
  x: {block: Integrator, u: slope, initial: -0.2586}
  slope: {block: Gain, u: y, gain: -63.94 Hz}
  y: {block: TransportDelay, u: x, delay: 6.502 ms, initial: -0.345}
record: [y]
)");
  for (std::size_t k = 0; k < column(run, "time").size(); ++k) {
    const double t = column(run, "time")[k];
    INFO(t);
    // Up to four delays x is a polynomial of degree 4 between the bends.
    if (t > delay && t < 4.0 * delay)
      CHECK(column(run, "y")[k] == Approx(exact(t - delay)).margin(1e-13).epsilon(0.0));
  }
}

TEST_CASE("a delay that is switched off and on keeps what it saw up to the instant") {
  // On from 0.123 to 0.323 s and from 0.623 to 0.823 s. Its input of 0.31 s before: nothing in the first time,
  // 0.313 to 0.323 from 0.623 to 0.633 s, and 0.323 up to 0.933 s.
  const double integral = 0.01 * 0.318 + 0.19 * 0.323;
  for (const std::string solver : {"rk4", "dormand_prince", "{name: dormand_prince, relative: 1e-8}"}) {
    INFO(solver);
    const table::Table run = run_text("step: 50 ms\nstop: 1 s\nevents: locate\nsolver: " + solver + R"(
blocks:
  on: {block: Pulse, period: 0.5 s, width: 0.4, delay: 0.123 s}
  ramp: {block: Ramp}
  late: {block: TransportDelay, u: ramp, delay: 310 ms, enable: {when: on, states: held}}
  x: {block: Integrator, u: late, enable: {when: on, states: held}}
record: [late, x]
)");
    CHECK(last(run, "late") == Approx(0.323).epsilon(1e-12));
    CHECK(last(run, "x") == Approx(integral).epsilon(1e-9));
  }
}

TEST_CASE("events of other blocks take no room of a delay for ever") {
  // Some 570 edges in 9 s, none of which bends the sine.
  const std::string text = R"(step: 100 ms
stop: 30 s
solver: rk4
events: locate
blocks:
  sine: {block: Sine, frequency: 0.1 Hz}
  late: {block: TransportDelay, u: sine, delay: 9 s}
  pulse: {block: Pulse, period: 31.7 ms, width: 0.4}
  count: {block: Integrator, u: pulse}
record: [late, count]
)";
  const table::Table run = run_text(text);
  const auto &t = column(run, "time"), &late = column(run, "late");
  for (std::size_t k = 0; k < t.size(); ++k)
    CHECK(late[k] == Approx(t[k] < 9.0 ? 0.0 : std::sin(0.2 * M_PI * (t[k] - 9.0))).margin(1e-7));
}

TEST_CASE("each run of a sweep over the delay keeps as much of the past as its own delay needs") {
  static const Registry registry = blocks();
  diagram::Loader loader(registry);
  loader.add(
      yaml::parse_document("stepwire: 1\ntitle: a sweep\nstep: 1 ms\nstop: 0.2 s\n"
                           "parameters: {p: 50 ms}\nsweep: {p: [50 ms, 51.5 ms, 120 ms, 20 ms]}\n"
                           "blocks:\n  t: {block: Clock}\n"
                           "  y: {block: TransportDelay, u: t, delay: $p}\nrecord: y\n",
                           "sweep.yaml"));
  const run::RunResult result = run::run_job(run::make_job(loader, "sweep.yaml"));
  const record::Recording& recording = result.recordings.at(0);
  const std::vector<double>& y = recording.table.find("y")->values;
  CHECK(result.faults.empty());
  REQUIRE(y.size() == 4 * 201);
  const double delays[] = {0.05, 0.0515, 0.12, 0.02};
  for (std::size_t run = 0; run < 4; ++run) CHECK(y[201 * run + 200] == Approx(0.2 - delays[run]));
}

}  // namespace stepwire
