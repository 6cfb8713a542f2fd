// Messages of implicit solvers for steps that are too large, on problems with published solutions.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/solve/solver.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::solve {
using Catch::Matchers::Contains;

namespace {

/// Robertson 1966: three species whose rates differ by nine powers of ten.
std::string robertson(const std::string& solver, const std::string& step, const std::string& more = "") {
  return "step: " + step + "\nstop: 40 s\nsolver: " + solver + "\n" + more + R"(
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

/// y'' = 1000 (1 - y^2) y' - y, from y = 2 at rest.
std::string van_der_pol(const std::string& solver, const std::string& step,
                        const std::string& stop = "2000 s") {
  return "step: " + step + "\nstop: " + stop + "\nsolver: " + solver + R"(
blocks:
  pull: {block: Expression, u: [y, v], expression: "1000*(1 - u1^2)*u2 - u1"}
  v: {block: Integrator, u: pull}
  y: {block: Integrator, u: v, initial: 2}
record: {every: 400 s, signals: [y, v]}
)";
}

// Robertson at 40 s: Hairer and Wanner, Solving ODEs II, and the example of CVODE (cvRoberts_dns) print
// 0.7158, 9.185e-6, 0.2842. Further digits are of SciPy 1.10.1, solve_ivp(f, (0, 40), [1, 0, 0], "Radau",
// jac=jac, rtol=3e-14, atol=1e-20); 14 of them are the same with rtol=1e-12, atol=1e-18.
constexpr double y1_at_40 = 0.715827068719406, y2_at_40 = 9.18553476455778e-6;

}  // namespace

TEST_CASE("sdirk has Robertson's problem right from steps of 20 ms down") {
  for (const char* step : {"20 ms", "10 ms", "5 ms"}) {
    INFO(step);
    const table::Table run = run_text(robertson("sdirk", step, "tolerance: 20 %"));
    CHECK(column(run, "y1").back() == Approx(y1_at_40).epsilon(1e-8));
    CHECK(column(run, "y2").back() == Approx(y2_at_40).epsilon(1e-7));
    CHECK(column(run, "y3").back() == Approx(1.0 - y1_at_40 - y2_at_40).epsilon(1e-8));
  }
}

TEST_CASE("rosenbrock has Robertson's problem right at 1 ms, and ends at 20 ms with state, time and error") {
  CHECK(column(run_text(robertson("rosenbrock", "1 ms")), "y1").back() == Approx(y1_at_40).epsilon(1e-8));
  for (const char* step : {"20 ms", "10 ms", "5 ms", "2 ms"}) {
    INFO(step);
    const std::string error = error_of(robertson("rosenbrock", step));
    CHECK_THAT(error, Contains("y2.x: the step to ") && Contains("errs by ") && Contains("solver: sdirk"));
  }
  CHECK_THAT(error_of(robertson("rosenbrock", "20 ms")), Contains("the step to 0.02 s"));
}

TEST_CASE("a file may raise or lower the bound on the error of a step") {
  CHECK(error_of(robertson("rosenbrock", "20 ms", "tolerance: 1e9\nstop_when: time > 0.1")).empty());
  CHECK(error_of(robertson("rosenbrock", "1 ms", "stop_when: time > 0.1")).empty());
  CHECK_THAT(error_of(robertson("rosenbrock", "1 ms", "tolerance: 0.1 %\nstop_when: time > 0.1")),
             Contains("'tolerance' is 0.001"));
  CHECK_THAT(error_of(robertson("sdirk", "20 ms", "tolerance: 1e-6")), Contains("'tolerance' is 1e-06"));
  CHECK_THAT(error_of(robertson("rosenbrock", "1 ms", "tolerance: 0")), Contains("must be above 0"));
  CHECK_THAT(error_of(robertson("rosenbrock", "1 ms", "tolerance: 1 s")), Contains("tolerance"));
}

TEST_CASE("Van der Pol's relaxation at too large a step ends with an error and not with numbers") {
  CHECK_THAT(error_of(van_der_pol("rosenbrock", "1 s")), Contains("errs by"));
  CHECK_THAT(error_of(van_der_pol("rosenbrock", "100 ms")), Contains("errs by"));
  CHECK_THAT(error_of(van_der_pol("sdirk", "1 s")), Contains("finds no solution for the step to 807 s"));
}

TEST_CASE("sdirk follows Van der Pol's slow way to shortly before its jump at 807 s") {
  // SciPy 1.10.1: solve_ivp(f, (0, 2000), [2, 0], "Radau", rtol=1e-12, atol=1e-14) at 800 s.
  const table::Table run = run_text(van_der_pol("sdirk", "50 ms", "800 s"));
  CHECK(column(run, "y").back() == Approx(1.08392336).epsilon(1e-8));
}

TEST_CASE("an input that jumps within a step moves what is at rest without a fault") {
  for (const char* solver : {"rosenbrock", "sdirk"})
    for (const char* time : {"0.5002 s", "0.5005 s", "0.5009 s"}) {
      INFO(solver << " " << time);
      const table::Table run = run_text(std::string("step: 1 ms\nstop: 1 s\nsolver: ") + solver +
                                        "\nblocks:\n  push: {block: Step, time: " + time + R"(, after: 10}
  a: {block: Integrator, u: push}
  b: {block: Integrator, u: a}
  c: {block: Integrator, u: b}
  d: {block: Lag, u: c, tau: 1 us}
record: [b]
)");
      CHECK(column(run, "b").back() == Approx(1.25).epsilon(0.01));  // 10 t^2 / 2 after half a second
    }
}

TEST_CASE("a law that jumps at the start of a step of rosenbrock is no stiffness") {
  // The state falls by 1 in each second down to 0.5, which is reached at a tick, and faster below.
  for (const char* events : {"tick", "locate"})
    for (const char* law :
         {"x > 0.5 ? -1 : -2", "x >= 0.5 ? -1 : -2", "x > 0.5 ? -1 : -1.01", "x > 0.5 ? -1 : -1.0001"}) {
      INFO(law << " " << events);
      const std::string head = std::string("step: 10 ms\nstop: 1 s\nevents: ") + events;
      const std::string blocks = std::string(R"(
blocks:
  x: {block: Integrator, u: rate, initial: 1}
  rate: {block: Expression, u: x, variables: [x], expression: ")") +
                                 law + "\"}\nrecord: [x]\n";
      const double right = column(run_text(head + "\nsolver: sdirk" + blocks), "x").back();
      CHECK(column(run_text(head + "\nsolver: rosenbrock" + blocks), "x").back() ==
            Approx(right).margin(1e-9));
      const std::string text(law);
      const double rate = std::stod(text.substr(text.rfind('-')));
      CHECK(right == Approx(0.5 + 0.5 * rate).margin(1e-9));
    }
}

TEST_CASE("a mode that is infinitely fast is gone after one step of sdirk") {
  // Its stability function is 0 at minus infinity, and falls to that as 1/z.
  for (const auto& [tau, most] : {std::pair{"1 ms", 1e-2}, {"1 us", 1e-5}, {"1 ns", 1e-8}}) {
    const table::Table run =
        run_text(std::string("step: 1 s\nstop: 1 s\nsolver: sdirk\nblocks:\n  x: {block: Lag, u: 0, "
                             "tau: ") +
                 tau + ", initial: 1}\nrecord: [x]\n");
    CHECK(std::abs(column(run, "x").back()) < most);
  }
}

TEST_CASE("a tolerance beside a solver that has none is refused, unless another solver may be meant") {
  const DiagramFolder folder;
  const std::string text = "stepwire: 1\n" + robertson("rk4", "1 ms", "tolerance: 1 %\n");
  folder.write("a.yaml", text);
  folder.write("swept.yaml", text + "sweep: {solver: [rk4, sdirk]}\n");
  diagram::Loader loader(library());
  const std::string cure = "tolerance: only rosenbrock and sdirk have one; take it out, or name one of these";
  CHECK_THROWS_WITH(run::make_job(loader, folder.path("a.yaml")), Contains("a.yaml:5:1") && Contains(cure));
  CHECK_NOTHROW(run::make_job(loader, folder.path("a.yaml"), {{"solver", "sdirk"}}));
  CHECK_NOTHROW(run::make_job(loader, folder.path("a.yaml"), {{"solver", "heun"}}));
  CHECK_NOTHROW(run::make_job(loader, folder.path("swept.yaml")));
  CHECK_THROWS_WITH(run::make_job(loader, folder.path("a.yaml"), {{"solver", "heun"}, {"tolerance", "2 %"}}),
                    Contains("--set tolerance=2 %") && Contains(cure));
  folder.write("own.yaml",
               "stepwire: 1\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nparameters: {tolerance: 0.1}\n"
               "blocks:\n  x: {block: Integrator, u: $tolerance}\nrecord: [x]\n");
  CHECK_NOTHROW(run::make_job(loader, folder.path("own.yaml"), {{"tolerance", "0.2"}}));
}

}  // namespace stepwire::solve
