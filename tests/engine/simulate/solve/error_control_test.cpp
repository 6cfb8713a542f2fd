// Problems of the test set for IVP solvers (Mazzia and Magherini, Bari, release 2.4) with the end values that
// it publishes, each from its start to its end in one call.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "engine/simulate/solve/solver.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::solve {
using Catch::Matchers::Contains;

namespace {

class Problem : public System {
 public:
  using Slope = std::function<void(const double* x, double* dot)>;

  Problem(Slope slope, std::vector<double> start, double length, std::vector<double> right)
      : right(std::move(right)), slope_(std::move(slope)), start_(std::move(start)), length_(length) {
    states_ = start_;
    slopes_.resize(states_.size());
    time = &time_;
    x = states_.data();
    dot = slopes_.data();
    count = states_.size();
  }
  void evaluate() override {
    ++calls;
    slope_(x, dot);
  }

  /// The digits of the worst state at the end.
  double digits(const std::string& solver, const ErrorControl& control) {
    std::copy(start_.begin(), start_.end(), x);
    time_ = 0.0;
    std::vector<double> numbers(ControlReport::count);
    report = {numbers.data()};
    calls = 0;
    evaluate();
    make_solver(solver, count, control)->advance(*this, {0.0, length_, length_});
    if (numbers[0] != StepReport::fine) return -1.0;
    double worst = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) worst = std::max(worst, std::abs(x[i] / right[i] - 1.0));
    return -std::log10(worst);
  }

  std::vector<double> right;
  long calls = 0;

 private:
  Slope slope_;
  std::vector<double> start_, states_, slopes_;
  double length_, time_ = 0.0;
};

Problem hires() {
  return {[](const double* y, double* f) {
            f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
            f[1] = 1.71 * y[0] - 8.75 * y[1];
            f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
            f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
            f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
            f[5] = -280.0 * y[5] * y[7] + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
            f[6] = 280.0 * y[5] * y[7] - 1.81 * y[6];
            f[7] = -f[6];
          },
          {1, 0, 0, 0, 0, 0, 0, 0.0057},
          321.8122,
          {0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4, 0.1175651343283149e-2,
           0.2386356198831331e-2, 0.6238968252742796e-2, 0.2849998395185769e-2, 0.2850001604814231e-2}};
}

Problem robertson() {
  return {[](const double* y, double* f) {
            f[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
            f[2] = 3e7 * y[1] * y[1];
            f[1] = -f[0] - f[2];
          },
          {1, 0, 0},
          1e11,
          {0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050}};
}

Problem oregonator() {
  return {[](const double* y, double* f) {
            f[0] = 77.27 * (y[1] + y[0] * (1.0 - 8.375e-6 * y[0] - y[1]));
            f[1] = (y[2] - (1.0 + y[0]) * y[1]) / 77.27;
            f[2] = 0.161 * (y[0] - y[2]);
          },
          {1, 2, 3},
          360.0,
          {0.1000814870318523e1, 0.1228178521549917e4, 0.1320554942846706e3}};
}

Problem van_der_pol() {
  return {[](const double* y, double* f) {
            f[0] = y[1];
            f[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / 1e-6;
          },
          {2, 0},
          2.0,
          {0.1706167732170483e1, -0.8928097010247975}};
}

/// Two bodies on an ellipse of eccentricity 0.6 (Hull, Enright, Fellen, Sedgwick 1972, class D), one turn:
/// back at the start.
Problem ellipse() {
  return {[](const double* y, double* f) {
            const double r3 = std::pow(y[0] * y[0] + y[1] * y[1], 1.5);
            f[0] = y[2];
            f[1] = y[3];
            f[2] = -y[0] / r3;
            f[3] = -y[1] / r3;
          },
          {0.4, 0.0, 0.0, 2.0},
          2.0 * 3.14159265358979323846,
          {0.4}};
}

}  // namespace

TEST_CASE("a stiff problem ends with the digits that are asked for, less one") {
  struct Case {
    const char* name;
    std::function<Problem()> make;
    double absolute;  ///< in parts of `relative`
  };
  const Case cases[] = {{"HIRES", hires, 1e-4},
                        {"Robertson", robertson, 1e-10},
                        {"OREGO", oregonator, 1e-3},
                        {"VDPOL", van_der_pol, 1e-3}};
  for (const Case& one : cases)
    for (const double relative : {1e-4, 1e-7})
      for (const char* solver : {"rodas", "auto"}) {
        Problem problem = one.make();
        const ErrorControl control{relative, one.absolute * relative, 10'000'000};
        const double digits = problem.digits(solver, control);
        INFO(one.name << " " << solver << " " << relative << ": " << digits << " digits, " << problem.calls
                      << " calls");
        CHECK(digits > -std::log10(relative) - 1.0);
      }
}

TEST_CASE("sdirk and rosenbrock end a stiff problem with nearly as many digits") {
  for (const char* solver : {"rosenbrock", "sdirk"})
    for (const double relative : {1e-4, 1e-6}) {
      Problem problem = hires();
      const double digits = problem.digits(solver, {relative, 1e-4 * relative, 10'000'000});
      INFO(solver << ": " << digits << " digits, " << problem.calls << " calls");
      CHECK(digits > -std::log10(relative) - 1.2);
    }
}

TEST_CASE("a smooth problem ends with the digits that are asked for, less one") {
  for (const double relative : {1e-4, 1e-7, 1e-10})
    for (const char* solver : {"dormand_prince", "bogacki_shampine", "auto", "rodas"}) {
      Problem problem = ellipse();
      const double digits = problem.digits(solver, {relative, relative, 10'000'000});
      INFO(solver << " " << relative << ": " << digits << " digits, " << problem.calls << " calls");
      CHECK(digits > -std::log10(relative) - 1.7);  // one turn makes an error of a step fifty times as large
    }
}

namespace {

std::string robertson_file(const std::string& solver) {
  return "step: 10000 s\nstop: 1e6 s\nsolver: " + solver + R"(
blocks:
  rates: {block: Expression, u: [y1, y2, y3], expression: "0.04*u1 - 1e4*u2*u3"}
  third: {block: Expression, u: y2, expression: "3e7*u*u"}
  y1: {block: Integrator, u: down, initial: 1}
  y2: {block: Integrator, u: between}
  y3: {block: Integrator, u: third}
  down: {block: Gain, u: rates, gain: -1}
  between: {block: Sum, signs: "+-", u: [rates, third]}
record: [y1, y2, y3]
)";
}

}  // namespace

TEST_CASE("Robertson's problem with a step of 10,000 s is right or ends with a sentence") {
  for (const char* solver : {"sdirk", "rosenbrock", "rk4", "dormand_prince"}) {
    INFO(solver);
    CHECK_FALSE(error_of(robertson_file(solver)).empty());
  }
  for (const char* solver : {"auto", "rodas", "{name: rodas, relative: 1e-8, absolute: 1e-14}",
                             "{name: sdirk, relative: 1e-5, absolute: 1e-11}"}) {
    INFO(solver);
    const table::Table run = run_text(robertson_file(solver));
    const double sum = column(run, "y1").back() + column(run, "y2").back() + column(run, "y3").back();
    CHECK(sum == Approx(1.0).epsilon(1e-6));
    // Radau of SciPy 1.10.1 with rtol 1e-10, atol 1e-16 gives 2.03148e-3.
    CHECK(column(run, "y1").back() == Approx(2.03148e-3).epsilon(1e-3));
  }
}

TEST_CASE("a solver that cannot control its error says which can") {
  const auto of = [](const std::string& solver) {
    return error_of("step: 1 s\nstop: 1 s\nsolver: " + solver +
                    "\nblocks:\n  x: {block: Integrator, u: 1}\n");
  };
  CHECK_THAT(of("{name: rk4, relative: 1e-6}"),
             Contains("rk4 has no estimate of its error") && Contains("dormand_prince"));
  CHECK_THAT(of("{relative: 1e-6}"), Contains("name"));
  CHECK_THAT(of("{name: auto, relative: 0}"), Contains("above 0"));
  CHECK_THAT(of("{name: dormand_price}"), Contains("dormand_prince"));
  CHECK_THAT(error_of(robertson_file("{name: dormand_prince, max_steps: 100}")), Contains("max_steps"));
}

}  // namespace stepwire::solve
