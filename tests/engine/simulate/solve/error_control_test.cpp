// Digits that controlled solvers end with on problems whose end values are published or have a closed form,
// each from its start to its end in one call.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/simulate/solve/solver.hpp"
#include "tests/support/ivp/bari.hpp"
#include "tests/support/ivp/detest.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::solve {
using Catch::Matchers::Contains;

namespace {

class ProblemSystem : public System {
 public:
  explicit ProblemSystem(const ivp::Problem& problem)
      : numbers(ControlReport::count(problem.start.size())),
        problem_(problem),
        states_(problem.start),
        derivatives_(states_.size()) {
    time = &time_;
    x = states_.data();
    dot = derivatives_.data();
    count = states_.size();
    report = {numbers.data()};
  }
  void evaluate() override {
    ++calls;
    problem_.derivative(time_, x, dot);
  }

  long calls = 0;
  std::vector<double> numbers;

 private:
  const ivp::Problem& problem_;
  std::vector<double> states_, derivatives_;
  double time_ = 0.0;
};

struct Outcome {
  double digits;
  long calls;
};

Outcome solve_problem(const ivp::Problem& problem, const std::string& solver, double relative) {
  ProblemSystem system(problem);
  system.evaluate();
  const ErrorControl control{relative, problem.absolute * relative, 10'000'000};
  make_solver(solver, system.count, control)->advance(system, {0.0, problem.end, problem.end});
  return {system.numbers[0] == StepReport::fine ? ivp::digits(problem, system.x) : -1.0, system.calls};
}

void check_digits(const ivp::Problem& problem, const std::string& solver, double relative, double fewer) {
  const Outcome outcome = solve_problem(problem, solver, relative);
  INFO(problem.name << " " << solver << " " << relative << ": " << outcome.digits << " digits, "
                    << outcome.calls << " calls");
  CHECK(outcome.digits > -std::log10(relative) - fewer);
}

ivp::Problem with_end(ivp::Problem problem, std::vector<double> right) {
  problem.right = std::move(right);
  return problem;
}

/// States at 20 of a body on an ellipse, by Kepler's equation.
std::vector<double> kepler(double eccentricity) {
  double anomaly = 20.0;
  for (int i = 0; i < 50; ++i)
    anomaly -= (anomaly - eccentricity * std::sin(anomaly) - 20.0) / (1.0 - eccentricity * std::cos(anomaly));
  const double root = std::sqrt(1.0 - eccentricity * eccentricity);
  const double rate = 1.0 / (1.0 - eccentricity * std::cos(anomaly));
  return {std::cos(anomaly) - eccentricity, root * std::sin(anomaly), -rate * std::sin(anomaly),
          rate * root * std::cos(anomaly)};
}

/// A chain of decays: each state is a term of Poisson's distribution of mean 20, the last one the rest.
std::vector<double> poisson() {
  std::vector<double> terms{std::exp(-20.0)};
  double sum = terms[0];
  for (int i = 1; i < 9; ++i) {
    terms.push_back(terms.back() * 20.0 / i);
    sum += terms.back();
  }
  terms.push_back(1.0 - sum);
  return terms;
}

}  // namespace

TEST_CASE("a stiff problem ends with the digits that are asked for, less about one") {
  for (const ivp::Problem& problem :
       {ivp::hires(), ivp::robertson(), ivp::oregonator(), ivp::van_der_pol(), ivp::pollution()})
    for (const double relative : {1e-4, 1e-7, 1e-10}) {
      for (const char* solver : {"radau", "auto"})
        check_digits(problem, solver, relative, relative > 1e-8 ? 1.0 : 1.1);
      if (relative > 1e-8) check_digits(problem, "rodas", relative, 1.0);
    }
  // The rounding of doubles leaves no more than four digits of the two states that end at 1e-22.
  for (const double relative : {1e-4, 1e-6})
    for (const char* solver : {"radau", "auto"}) check_digits(ivp::e5(), solver, relative, 1.0);
}

TEST_CASE("Robertson's problem ends with nine digits where ten are asked for") {
  for (const char* solver : {"radau", "auto"}) check_digits(ivp::robertson(), solver, 1e-10, 1.0);
}

TEST_CASE("radau evaluates a stiff problem at most 2.5 times as often as CVODE") {
  struct Case {
    ivp::Problem problem;
    double relative;
    long cvode;  ///< evaluations of CVODE 6.4.1 with BDF and a dense Jacobian by differences (bench/solvers)
  };
  for (const auto& [problem, relative, cvode] :
       {Case{ivp::hires(), 1e-4, 524}, Case{ivp::hires(), 1e-7, 1076}, Case{ivp::robertson(), 1e-10, 5416},
        Case{ivp::oregonator(), 1e-7, 4985}, Case{ivp::pollution(), 1e-4, 372},
        Case{ivp::pollution(), 1e-7, 784}, Case{ivp::pollution(), 1e-10, 1560}}) {
    const Outcome outcome = solve_problem(problem, "radau", relative);
    INFO(problem.name << " " << relative << ": " << outcome.calls << " calls");
    CHECK(static_cast<double>(outcome.calls) < 2.5 * static_cast<double>(cvode));
  }
}

namespace {

void check_default_tolerance(ivp::Problem problem, const std::string& solver, int ticks) {
  const ErrorControl usual;
  problem.absolute = usual.absolute / usual.relative;
  ProblemSystem system(problem);
  const auto method = make_solver(solver, system.count, usual);
  const double step = problem.end / ticks;
  for (int k = 0; k < ticks && system.numbers[0] == StepReport::fine; ++k) {
    *system.time = k * step;
    system.evaluate();
    method->advance(system, {k * step, (k + 1) * step, step});
  }
  INFO(problem.name << " " << solver << " " << ticks << ": " << ivp::digits(problem, system.x) << " digits");
  CHECK((system.numbers[0] != StepReport::fine || ivp::digits(problem, system.x) > 3.0));
}

}  // namespace

TEST_CASE("with the default tolerance a stiff problem ends right or stops, whatever the step of the file") {
  for (const ivp::Problem& problem :
       {ivp::hires(), ivp::robertson(), ivp::oregonator(), ivp::van_der_pol(), ivp::pollution(), ivp::e5()}) {
    for (const char* solver : {"auto", "radau", "rodas"})
      for (const int ticks : {1, 30, 1000}) check_default_tolerance(problem, solver, ticks);
    for (const char* solver : {"rosenbrock", "sdirk", "dormand_prince", "dop853"})
      check_default_tolerance(problem, solver, 1);
  }
}

TEST_CASE("sdirk and rosenbrock end a stiff problem with nearly as many digits") {
  for (const char* solver : {"rosenbrock", "sdirk"})
    for (const double relative : {1e-4, 1e-6}) check_digits(ivp::hires(), solver, relative, 1.2);
}

TEST_CASE("a smooth problem of DETEST ends with the digits that are asked for, less one") {
  using namespace ivp::detest;
  const std::vector<ivp::Problem> problems{
      with_end(a()[0], {std::exp(-20.0)}), with_end(a()[1], {1.0 / std::sqrt(21.0)}),
      with_end(a()[3], {20.0 / (1.0 + 19.0 * std::exp(-5.0))}), with_end(c()[0], poisson())};
  for (const ivp::Problem& problem : problems)
    for (const double relative : {1e-4, 1e-7, 1e-10})
      for (const char* solver : {"dormand_prince", "dop853", "bogacki_shampine", "auto", "radau"})
        check_digits(problem, solver, relative, 1.0);
}

TEST_CASE("a body on an ellipse ends three turns later within the growth of the error") {
  using ivp::detest::orbit;
  // An error of the energy moves the body along its way: it grows with the square of the turns. CVODE ends
  // with 0.8 to 1.5 digits at 1e-4 and 6.4 to 7.7 at 1e-10.
  for (const double eccentricity : {0.1, 0.5, 0.9})
    for (const double relative : {1e-7, 1e-10})
      for (const char* solver : {"dormand_prince", "dop853", "auto"})
        check_digits(with_end(orbit("orbit", eccentricity), kepler(eccentricity)), solver, relative, 2.6);
}

TEST_CASE("one turn on an ellipse costs less than two digits of those that are asked for") {
  // It ends where it began. One turn makes an error of a step fifty times as large. Only the first state
  // counts.
  ivp::Problem turn = with_end(ivp::detest::orbit("one turn", 0.6), {0.4});
  turn.end = 2.0 * std::numbers::pi;
  turn.absolute = 1.0;
  for (const double relative : {1e-4, 1e-7, 1e-10})
    for (const char* solver : {"dormand_prince", "bogacki_shampine", "auto", "rodas"})
      check_digits(turn, solver, relative, 1.7);
}

TEST_CASE("seven stars end with more digits than with CVODE") {
  // CVODE 6.4.1 with Adams: 3.3 digits at 1e-7, 6.1 at 1e-10 (bench/solvers).
  CHECK(solve_problem(ivp::pleiades(), "dop853", 1e-7).digits > 4.3);
  CHECK(solve_problem(ivp::pleiades(), "auto", 1e-10).digits > 8.0);
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

TEST_CASE("a fixed step on Robertson's problem is right or the run ends with a sentence") {
  for (const char* solver : {"rosenbrock", "sdirk"})
    for (const double step : {1.0, 30.0, 1e3, 1e5, 3e5, 1e6}) {
      const ivp::Problem problem = ivp::robertson();
      ProblemSystem system(problem), exact(problem);
      system.report.tolerance = 0.1;
      const auto method = make_solver(solver, 3);
      for (int k = 0; k < 3 && system.numbers[0] == StepReport::fine; ++k) {
        *system.time = k * step;
        system.evaluate();
        method->advance(system, {k * step, (k + 1) * step, step});
      }
      exact.evaluate();
      make_solver("radau", 3, ErrorControl{1e-9, 1e-18})->advance(exact, {0.0, 3.0 * step, 3.0 * step});
      INFO(solver << " " << step << " s: " << system.x[0] << ", right is " << exact.x[0]);
      CHECK((system.numbers[0] != StepReport::fine || std::abs(system.x[0] / exact.x[0] - 1.0) < 0.1));
    }
}

TEST_CASE("Robertson's problem with a step of 10,000 s is right or ends with a sentence") {
  for (const char* solver : {"sdirk", "rosenbrock", "rk4", "dormand_prince"}) {
    INFO(solver);
    CHECK_FALSE(error_of(robertson_file(solver)).empty());
  }
  for (const char* solver : {"auto", "rodas", "radau", "{name: rodas, relative: 1e-8, absolute: 1e-14}",
                             "{name: sdirk, relative: 1e-5, absolute: 1e-11}"}) {
    INFO(solver);
    const table::Table run = run_text(robertson_file(solver));
    const double sum = column(run, "y1").back() + column(run, "y2").back() + column(run, "y3").back();
    CHECK(sum == Approx(1.0).epsilon(1e-6));
    // Radau of SciPy 1.10.1 with rtol 1e-10, atol 1e-16 gives 2.03148e-3.
    CHECK(column(run, "y1").back() == Approx(2.03148e-3).epsilon(1e-3));
  }
}

TEST_CASE("a state below the absolute tolerance is noted") {
  // x'' = -10,000 x, whose solution is x(0) cos(100 t). From 1 pm it is lost: the tolerance is 1e-9.
  const auto notes = [](const std::string& from, const std::string& solver) {
    return result_of(
        "step: 50 ms\nstop: 1 s\nsolver: " + solver +
        "\nblocks:\n  force: {block: Gain, gain: -1e4, u: x}\n  v: {block: Integrator, u: force}\n"
        "  x: {block: Integrator, u: v, initial: " +
        from + "}\n  rest: {block: Integrator, u: 0}\nrecord: [x, rest]\n");
  };
  const run::RunResult small = notes("1e-12", "auto");
  REQUIRE(small.diagnostics.size() == 2);  // none for the state that is 0
  CHECK_THAT(small.diagnostics[1].block, Contains("x"));
  CHECK_THAT(small.diagnostics[1].text, Contains("may err by 1e-09; set 'absolute'"));
  CHECK(notes("1", "auto").diagnostics.empty());
  const run::RunResult set = notes("1e-12", "{name: dormand_prince, relative: 1e-8, absolute: 1e-20}");
  CHECK(set.diagnostics.empty());
  CHECK(column(set.recordings.front().table, "x").back() == Approx(1e-12 * std::cos(100.0)).epsilon(1e-4));
}

namespace {

/// Pendulums of different lengths that swing on their own, x'' = -k sin(x), with their states in any order.
class Pendulums : public System {
 public:
  explicit Pendulums(const std::vector<std::size_t>& order)
      : numbers_(ControlReport::count(order.size())),
        order_(order),
        states_(order.size()),
        slopes_(order.size()) {
    for (std::size_t i = 0; i < order.size(); ++i)
      at(i) = i % 2 == 0 ? 0.3 + 0.1 * static_cast<double>(i) : 0.0;
    time = &time_;
    x = states_.data();
    dot = slopes_.data();
    count = states_.size();
    report = {numbers_.data()};
    evaluate();
  }
  void evaluate() override {
    for (std::size_t i = 0; i < order_.size(); i += 2) {
      slopes_[order_[i]] = at(i + 1);
      slopes_[order_[i + 1]] = -(1.0 + 0.7 * static_cast<double>(i)) * std::sin(at(i));
    }
  }
  std::vector<double> ordered() {
    std::vector<double> all;
    for (std::size_t i = 0; i < order_.size(); ++i) all.push_back(at(i));
    return all;
  }

 private:
  double& at(std::size_t state) { return states_[order_[state]]; }

  std::vector<double> numbers_;
  std::vector<std::size_t> order_;
  std::vector<double> states_, slopes_;
  double time_ = 0.0;
};

}  // namespace

TEST_CASE("the order of states changes no bit of what an explicit solver with error control computes") {
  const std::vector<std::size_t> orders[] = {
      {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {9, 8, 7, 6, 5, 4, 3, 2, 1, 0}, {4, 9, 0, 7, 2, 5, 8, 1, 6, 3}};
  for (const char* solver : {"bogacki_shampine", "dormand_prince", "dop853"})
    for (const double relative : {1e-3, 1e-5, 1e-7, 1e-9}) {
      INFO(solver << " " << relative);
      std::vector<std::vector<double>> ends;
      for (const auto& order : orders) {
        Pendulums system(order);
        make_solver(solver, system.count, ErrorControl{relative, relative, 1'000'000})
            ->advance(system, {0.0, 20.0, 20.0});
        ends.push_back(system.ordered());
      }
      CHECK(ends[1] == ends[0]);
      CHECK(ends[2] == ends[0]);
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
