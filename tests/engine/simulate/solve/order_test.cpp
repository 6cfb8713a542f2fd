#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "engine/simulate/solve/explicit_solver.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::solve {

namespace {

/// x' = f(t, x) with the exact solution x(t).
class Problem : public System {
 public:
  using Slope = std::function<void(double t, const double* x, double* dot)>;
  using Solution = std::function<std::vector<double>(double t)>;

  Problem(Slope slope, Solution solution)
      : slope_(std::move(slope)), solution_(std::move(solution)), states_(solution_(0.0)) {
    slopes_.resize(states_.size());
    time = &time_;
    x = states_.data();
    dot = slopes_.data();
    count = states_.size();
  }
  void evaluate() override { slope_(time_, x, dot); }

  /// The largest error at the end, after `steps` equal steps to `stop`.
  double error(const std::string& solver_name, int steps, double stop) {
    return error(*make_solver(solver_name, count), steps, stop);
  }
  double error(Solver& solver, int steps, double stop) {
    std::copy_n(solution_(0.0).begin(), count, x);
    const double step = stop / steps;
    for (int k = 0; k < steps; ++k) {
      time_ = k * step;
      evaluate();
      solver.advance(*this, {k * step, (k + 1) * step, step});
    }
    const std::vector<double> exact = solution_(stop);
    double worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) worst = std::max(worst, std::abs(x[i] - exact[i]));
    return worst;
  }

 private:
  Slope slope_;
  Solution solution_;
  double time_ = 0.0;
  std::vector<double> states_, slopes_;
};

/// The logistic equation, which is not linear.
Problem logistic() {
  return {[](double, const double* x, double* dot) { dot[0] = x[0] * (1.0 - x[0]); },
          [](double t) { return std::vector{1.0 / (1.0 + 3.0 * std::exp(-t))}; }};
}

/// x' = -2 t x^2, which depends on time as well: x = 1 / (1 + t^2).
Problem with_time() {
  return {[](double t, const double* x, double* dot) { dot[0] = -2.0 * t * x[0] * x[0]; },
          [](double t) { return std::vector{1.0 / (1.0 + t * t)}; }};
}

/// A pendulum's worth of coupling: x1' = x2, x2' = -x1 + forcing, with the solution x1 = sin t + sin 2t.
Problem forced_oscillator() {
  return {[](double t, const double* x, double* dot) {
            dot[0] = x[1];
            dot[1] = -x[0] - 3.0 * std::sin(2.0 * t);
          },
          [](double t) {
            return std::vector{std::sin(t) + std::sin(2.0 * t), std::cos(t) + 2.0 * std::cos(2.0 * t)};
          }};
}

double measured_order(Problem problem, const std::string& solver, int steps, double stop) {
  return std::log2(problem.error(solver, steps, stop) / problem.error(solver, 2 * steps, stop));
}

double measured_order(Problem (*problem)(), const Tableau& tableau, int steps, double stop) {
  const auto error = [&](int count) {
    Problem own = problem();
    ExplicitSolver solver(tableau, own.count);
    return own.error(solver, count, stop);
  };
  return std::log2(error(steps) / error(2 * steps));
}

}  // namespace

TEST_CASE("every solver converges with its order") {
  for (const SolverKind& kind : solver_kinds()) {
    if (!kind.fixed) continue;
    INFO(kind.name);
    // Steps small enough for the order to show, large enough for rounding not to.
    const int steps = kind.order == 5 ? 20 : kind.order == 4 ? 40 : 400;
    CHECK(measured_order(logistic(), kind.name, steps, 1.0) == Approx(kind.order).margin(0.15));
    CHECK(measured_order(with_time(), kind.name, steps, 1.0) == Approx(kind.order).margin(0.15));
    CHECK(measured_order(forced_oscillator(), kind.name, steps, 2.0) == Approx(kind.order).margin(0.15));
  }
}

TEST_CASE("a solver of order p integrates a polynomial of degree p in time exactly") {
  for (const SolverKind& kind : solver_kinds()) {
    if (!kind.fixed) continue;
    if (kind.name == "rosenbrock") continue;  // its derivative in time is a difference
    if (kind.name == "sdirk") continue;       // checked below: corrections end near the rounding
    INFO(kind.name);
    const double p = kind.order;
    Problem problem([p](double t, const double*, double* dot) { dot[0] = p * std::pow(t, p - 1.0); },
                    [p](double t) { return std::vector{std::pow(t, p)}; });
    CHECK(problem.error(kind.name, 3, 1.7) < 1e-14 * std::pow(1.7, p) * 10);
  }
}

TEST_CASE("no solver is of higher order than it says") {
  for (const SolverKind& kind : solver_kinds()) {
    if (!kind.fixed) continue;
    INFO(kind.name);
    CHECK(logistic().error(kind.name, 4, 2.0) > 1e-8);
  }
}

TEST_CASE("a method may leave out its last slope, and a stage the slope before it") {
  // Fehlberg 1969, NASA TR R-315: the fourth-order method of his pair, which weighs the sixth slope by 0.
  const Tableau fehlberg{{1.0 / 4, 3.0 / 8, 12.0 / 13, 1.0, 1.0 / 2},
                         {{1.0 / 4},
                          {3.0 / 32, 9.0 / 32},
                          {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
                          {439.0 / 216, -8.0, 3680.0 / 513, -845.0 / 4104},
                          {-8.0 / 27, 2.0, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}},
                         {25.0 / 216, 0.0, 1408.0 / 2565, 2197.0 / 4104, -1.0 / 5, 0.0}};
  // Simpson's rule with an explicit middle and an explicit end, which both come from the first slope alone.
  const Tableau simpson{{1.0 / 2, 1.0}, {{1.0 / 2}, {1.0, 0.0}}, {1.0 / 6, 2.0 / 3, 1.0 / 6}};
  for (Problem (*problem)() : {logistic, with_time})
    CHECK(measured_order(problem, simpson, 400, 1.0) == Approx(2.0).margin(0.15));
  CHECK(measured_order(forced_oscillator, fehlberg, 40, 2.0) == Approx(4.0).margin(0.15));
}

}  // namespace stepwire::solve
