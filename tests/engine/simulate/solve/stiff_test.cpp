#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/solve/solver.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::solve {

namespace {

/// A slow mode beside one that is 1e6 times faster, at steps of 10 ms.
std::string stiff_plant(const std::string& solver) {
  return R"(
step: 10 ms
stop: 1 s
solver: )" +
         solver + R"(
blocks:
  plant: {block: StateSpace, A: [[-1, 0], [1e6, -1e6]], B: [[0], [0]], C: [[1, 0], [0, 1]], D: [[0], [0]], u: 0, initial: [1, 0]}
record: [plant]
)";
}

/// x' = -rate x.
class Decay : public System {
 public:
  explicit Decay(double rate) : rate_(rate) {
    time = &time_;
    x = &state_;
    dot = &slope_;
    count = 1;
  }
  void evaluate() override { slope_ = -rate_ * state_; }
  /// Returns the state after one step of 1 s from x = 1.
  double factor(const std::string& solver) {
    state_ = 1.0;
    evaluate();
    make_solver(solver, 1)->advance(*this, {0.0, 1.0, 1.0});
    return state_;
  }

 private:
  double rate_, time_ = 0.0, state_ = 1.0, slope_ = 0.0;
};

}  // namespace

TEST_CASE("the Rosenbrock solver follows a stiff plant on which the classical method blows up") {
  const table::Table run = run_text(stiff_plant("rosenbrock"));
  CHECK(column(run, "plant.1").back() == Approx(std::exp(-1.0)).epsilon(1e-4));
  CHECK(column(run, "plant.2").back() == Approx(std::exp(-1.0)).epsilon(1e-4));
  CHECK_THAT(error_of(stiff_plant("rk4")), Catch::Contains("plant") && Catch::Contains("became"));
}

TEST_CASE("a mode that is infinitely fast is gone after one step of the Rosenbrock solver") {
  for (const double rate : {1e3, 1e6, 1e9}) CHECK(std::abs(Decay(rate).factor("rosenbrock")) < 10.0 / rate);
  CHECK(std::abs(Decay(1e3).factor("rk4")) > 1e9);
}

TEST_CASE("the Rosenbrock solver's stability function is that of its paper") {
  const double d = 1.0 / (2.0 + std::sqrt(2.0));
  for (const double z : {-0.1, -1.0, -10.0, -100.0}) {
    const double r = (1.0 + (1.0 - 2.0 * d) * z) / ((1.0 - d * z) * (1.0 - d * z));
    CHECK(Decay(-z).factor("rosenbrock") == Approx(r).margin(1e-6));
  }
}

TEST_CASE("a solver that is not known is refused where it stands, with the nearest name") {
  const auto refused = faults_of("solver: rk5\nblocks:\n  x: {block: Integrator, u: 1}\n");
  REQUIRE(refused.size() == 1);
  CHECK(refused[0] ==
        "test.yaml:1:9: solver: there is no solver 'rk5'; did you mean 'rk4'? Known are: euler, heun, "
        "bogacki_shampine, "
        "rk4, dormand_prince, dop853, rosenbrock, sdirk, rodas, radau, auto");
}

TEST_CASE("a solver of another program is answered with the one of its use") {
  const auto answer = [](const std::string& name) {
    const auto refused = faults_of("solver: " + name + "\nblocks:\n  x: {block: Integrator, u: 1}\n");
    const std::string begin =
        "test.yaml:1:9: solver: there is no solver '" + name + "'; in its place write '";
    REQUIRE(refused.size() == 1);
    return refused[0].starts_with(begin) ? refused[0].substr(begin.size()) : refused[0];
  };
  for (const char* name : {"ode45", "RK45", "dopri5"})
    CHECK(answer(name) == "solver: {name: dormand_prince, relative: 1e-6}'");
  CHECK(answer("ode23") == "solver: {name: bogacki_shampine, relative: 1e-6}'");
  for (const char* name : {"ode15s", "ode23t", "cvode", "BDF", "Radau"})
    CHECK(answer(name) == "solver: {name: radau, relative: 1e-6}'");
  CHECK(answer("lsoda") == "solver: {name: auto, relative: 1e-6}'");
  CHECK(answer("ode1") == "solver: euler'");
  CHECK(answer("ode3") == "solver: bogacki_shampine'");
  CHECK(answer("ode4") == "solver: rk4'");
}

}  // namespace stepwire::solve
