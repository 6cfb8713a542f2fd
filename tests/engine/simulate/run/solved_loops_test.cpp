#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <tuple>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// W of exp(x), for any x: w + log(w) = x by Newton's method.
double lambert_of_exp(double x) {
  double w = x > 1.0 ? x : std::exp(x);
  for (int i = 0; i < 100; ++i) w -= (w + std::log(w) - x) / (1.0 + 1.0 / w);
  return w;
}

const char* const thirds = R"(step: 0.01 s
stop: 2 s
algebraic_loops: solve
blocks:
  x: {block: Sine, frequency: 1 Hz, bias: 0.2}
  y: {block: Sum, signs: "+-", u: [x, half]}
  half: {block: Gain, gain: 0.5, u: y}
record: [x, y]
)";

}  // namespace

TEST_CASE("a linear loop is solved to the last bits") {
  const table::Table run = run_text(thirds);
  const auto &x = column(run, "x"), &y = column(run, "y");
  REQUIRE(x.size() == 201);
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(std::abs(y[k] - 2.0 * x[k] / 3.0) <= 2.0 * std::abs(std::nextafter(y[k], 9.0) - y[k]));
}

TEST_CASE("a diode behind a resistor has the voltage that Lambert's function gives") {
  const table::Table run = run_text(R"yaml(step: 0.01 s
stop: 1 s
algebraic_loops: solve
blocks:
  source: {block: Sine, amplitude: 5, frequency: 1 Hz}
  v: {block: Sum, signs: "+-", u: [source, drop]}
  drop: {block: Gain, gain: 1000, u: i}
  i: {block: Expression, u: v, expression: "1e-12*(exp(u/0.02585) - 1)"}
record: [source, v]
)yaml");
  const auto &source = column(run, "source"), &v = column(run, "v");
  const double resistance = 1000.0, saturation = 1e-12, thermal = 0.02585;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double all = source[k] + resistance * saturation;
    const double closed =
        all - thermal * lambert_of_exp(std::log(resistance * saturation / thermal) + all / thermal);
    CHECK(v[k] == Approx(closed).margin(1e-13).epsilon(1e-13));
  }
}

TEST_CASE("a loop of vectors, and one in which two loops meet, are solved") {
  const table::Table run = run_text(R"(step: 1 s
stop: 3 s
algebraic_loops: solve
blocks:
  x: {block: Constant, value: [1, 2, 3]}
  t: {block: Clock}
  y: {block: Sum, u: [x, turned]}
  turned: {block: MatrixGain, gain: [[0, 0.5, 0], [0, 0, -2], [1, 0, 0]], u: y}
  a: {block: Sum, signs: "++-", u: [t, b, c]}
  b: {block: Gain, gain: 0.25, u: a}
  c: {block: Sum, u: [half, t]}
  half: {block: Gain, gain: 0.5, u: c2}
  c2: {block: Sum, u: [c, a]}
record: [y, a, c]
)");
  // y = x + M y by hand: y1 = 1 + y2/2, y2 = 2 - 2 y3, y3 = 3 + y1, so y1 = 2 - y3, y3 = 2.5.
  CHECK(column(run, "y.1").back() == Approx(-0.5).epsilon(1e-15));
  CHECK(column(run, "y.2").back() == Approx(-3.0).epsilon(1e-15));
  CHECK(column(run, "y.3").back() == Approx(2.5).epsilon(1e-15));
  // a = t + a/4 - c, c = (c + a)/2 + t: c = a + 2 t, a = -4 t/7.
  CHECK(column(run, "a").back() == Approx(-4.0 * 3.0 / 7.0).epsilon(1e-15));
  CHECK(column(run, "c").back() == Approx(-4.0 * 3.0 / 7.0 + 6.0).epsilon(1e-15));
}

TEST_CASE("a block of a slower period keeps its output between its ticks, and the loop is open") {
  const table::Table run = run_text(R"(step: 1 s
stop: 7 s
algebraic_loops: solve
blocks:
  t: {block: Clock}
  u: {block: Gain, gain: -3, u: y, every: 4 s}
  y: {block: Sum, u: [t, u]}
record: [u, y]
)");
  const auto &u = column(run, "u"), &y = column(run, "y");
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double t = static_cast<double>(k), last = k < 4 ? 0.0 : 4.0;
    CHECK(u[k] == Approx(-0.75 * last).margin(1e-15));
    CHECK(y[k] == Approx(t - 0.75 * last).margin(1e-15));
  }
}

TEST_CASE("loops are solved at the stages of each solver, too") {
  for (const char* solver : {"rk4", "dormand_prince", "rosenbrock", "sdirk"}) {
    INFO(solver);
    // x' = y, y = -x - y/2: x falls as exp(-2 t/3).
    const table::Table run = run_text(std::string("solver: ") + solver + R"(
step: 1 ms
stop: 1 s
algebraic_loops: solve
blocks:
  x: {block: Integrator, u: y, initial: 1}
  y: {block: Sum, signs: "--", u: [x, half]}
  half: {block: Gain, gain: 0.5, u: y}
record: [x]
)");
    CHECK(column(run, "x").back() == Approx(std::exp(-2.0 / 3.0)).epsilon(1e-6));
  }
}

TEST_CASE("a loop that has no solution ends the run with its path, tick and residual") {
  const RunResult result = result_of(R"(step: 0.5 s
algebraic_loops: solve
blocks:
  t: {block: Clock}
  e: {block: Sum, signs: "+-", u: [t, y]}
  y: {block: Relay, switch_on: 0.75, switch_off: 0.75, when_on: 1, when_off: 0, u: e}
record: [t]
)");
  REQUIRE(result.faults.size() == 1);
  const std::string text = result.faults[0].fault.text();
  CHECK_THAT(text, Catch::Contains("the algebraic loop e -> y -> e is not solved at 1 s (tick 2)") &&
                       Catch::Contains("differs by ") && Catch::Contains("test.yaml:"));
  CHECK(result.recordings.front().table.columns.front().values.back() == 0.5);
}

TEST_CASE("a loop that grows by itself has no solution") {
  const RunResult result = result_of(R"(algebraic_loops: solve
blocks:
  t: {block: Clock}
  y: {block: Sum, u: [t, y, 1]}
record: [y]
)");
  REQUIRE(result.faults.size() == 1);
}

TEST_CASE("so few iterations that a loop is not solved end the run, or not where it must go on") {
  const plan::Plan plan = plan_text(R"(algebraic_loops: {max_iterations: 3}
blocks:
  t: {block: Clock}
  y: {block: Expression, u: [t, y], expression: "u1 - u2^3 + 2"}
record: [y]
)");
  Executor ends(plan);
  ends.evaluate();
  CHECK_FALSE(ends.healthy());
  Executor goes_on(plan);
  goes_on.go_on_unsolved();
  goes_on.evaluate();
  goes_on.advance();
  CHECK(goes_on.healthy());
  const std::vector<LoopCost> costs = goes_on.loop_costs();
  REQUIRE(costs.size() == 1);
  CHECK(costs[0].path == "y -> y");
  CHECK(costs[0].unsolved == 1);
  CHECK(costs[0].most <= 4);
}

TEST_CASE("what a loop has cost is known after a run") {
  const RunResult result = result_of(thirds);
  REQUIRE(result.loops.size() == 1);
  CHECK(result.loops[0].unknowns == 1);
  CHECK(result.loops[0].instants == 201);
  CHECK(result.loops[0].iterations >= 201);
  CHECK(result.loops[0].iterations <= 201 * 6);
}

TEST_CASE("a run that goes back to a moment solves its loops to the same bits") {
  const plan::Plan plan = plan_text(thirds);
  Executor run(plan);
  const auto go = [&] {
    for (int tick = 0; tick < 20; ++tick) {
      run.evaluate();
      run.advance();
    }
    return run.workspace().values;
  };
  go();
  const Workspace moment = run.workspace();
  const std::vector<double> first = go();
  run.restore(moment);
  CHECK(go() == first);
}

TEST_CASE("loops of constants have the bits of a new run, too, where a run goes back to a moment") {
  std::string blocks = "step: 1 s\nstop: 3 s\nalgebraic_loops: solve\nblocks:\n";
  for (int i = 1; i <= 40; ++i)
    blocks += fmt::format("  y{0}: {{block: Expression, u: [y{0}], expression: cos(u) + {0}/7}}\n", i);
  const plan::Plan plan = plan_text(blocks);
  Executor run(plan);
  const std::vector<double> first = run.workspace().values;
  run.restore(Workspace(run.workspace()));
  CHECK(run.workspace().values == first);
}

TEST_CASE("a loop that is solved again at its instant keeps its bits, where a run goes back to a moment") {
  // The row follows 1.7 y cos(t), so rounding is left in the residual of y. The body alone has states.
  const plan::Plan of_time = plan_text(R"(step: 1 ms
stop: 0.227 s
solver: rosenbrock
algebraic_loops: solve
blocks:
  t: {block: Sine}
  q: {block: QuaternionProduct, left: 0.5, right: t}
  of: {block: LookupTable2D, row: y, column: q, rows: [-0.5097, -0.1496], values: [[-1.796, 1.698], [-0.2416, -0.3219]], extrapolation: linear}
  body: {block: Mass, force: 0.5}
  y: {block: Gain, u: of}
record: [y, body.position]
)");
  // Each number solves this loop: the guess alone decides.
  const plan::Plan of_guess = plan_text(R"(step: 1 ms
stop: 20 ms
algebraic_loops: solve
blocks:
  y: {block: InitialGuess, u: same, guess: -0.8477}
  same: {block: Gain, u: y}
record: [y]
)");
  for (const plan::Plan* plan : {&of_time, &of_guess}) {
    Executor run(*plan);
    std::vector<Workspace> moments;
    std::vector<double> rows;
    const std::size_t y = plan->slot(plan->diagram.records.front().signals.front().signal).offset;
    for (std::int64_t tick = 0; tick < plan->steps; ++tick) {
      moments.push_back(run.workspace());
      run.evaluate();
      rows.push_back(run.values()[y]);
      run.advance();
    }
    bool same = true;
    for (const Workspace& moment : moments) {
      run.restore(moment);
      for (std::int64_t tick = moment.tick; tick < std::min(plan->steps, moment.tick + 3); ++tick) {
        run.evaluate();
        same = same && run.values()[y] == rows[static_cast<std::size_t>(tick)];
        run.advance();
      }
    }
    CHECK(same);
    CHECK(rows.front() != 0.0);
  }
}

TEST_CASE("a loop that has no solution at a guess alone is found from another") {
  const table::Table run = run_text(R"(step: 1 s
stop: 3 s
algebraic_loops: solve
blocks:
  t: {block: Clock}
  y: {block: Expression, u: [t, y], expression: "(u1 + 2)/u2"}
record: [y]
)");
  CHECK(column(run, "y").back() == Approx(std::sqrt(5.0)).epsilon(1e-14));
}

TEST_CASE("a loop with a limit crosses it once, and has the solution of both sides") {
  // y = f(s - R y) for f = min, a saturation or a dead zone: each is a closed form of s.
  const double R = 1.944, limit = 0.236;
  const auto dead = [&](double s) {
    return std::copysign(std::max(std::abs(s) - limit, 0.0), s) / (1.0 + R);
  };
  const std::tuple<std::string, std::function<double(double)>> laws[] = {
      {"{block: Saturation, u: g, lower: -0.236, upper: 0.236}",
       [&](double s) { return std::clamp(s / (1.0 + R), -limit, limit); }},
      {"{block: MinMax, function: min, u: [g, 0.236]}",
       [&](double s) { return std::min(s / (1.0 + R), limit); }},
      {"{block: DeadZone, u: g, lower: -0.236, upper: 0.236}", dead}};
  for (const auto& [block, law] : laws)
    for (const char* solver :
         {"{name: dormand_prince, relative: 1e-8, absolute: 1e-10}", "auto", "radau", "sdirk", "rk4"})
      for (const char* frequency : {"1.561 Hz", "0.93 Hz"}) {
        INFO(block << " " << solver << " " << frequency);
        const RunResult result = result_of(
            "algebraic_loops: solve\nevents: locate\nstep: 10 ms\nstop: 2 s\nsolver: " + std::string(solver) +
            "\nblocks:\n  s: {block: Sine, frequency: " + frequency +
            "}\n  g: {block: Expression, u: [s, y], expression: u1 - 1.944*u2}\n  y: " + block +
            "\n  i: {block: Integrator, u: y}\nrecord: [s, y, i]\n");
        REQUIRE(result.faults.empty());
        const auto& columns = result.recordings.front().table.columns;
        double worst = 0.0;
        for (std::size_t row = 0; row < columns[1].values.size(); ++row)
          worst = std::max(worst, std::abs(columns[2].values[row] - law(columns[1].values[row])));
        CHECK(worst < 1e-14);
      }
}

}  // namespace stepwire::run
