#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "engine/simulate/solve/event_locator.hpp"

using namespace stepwire;

namespace {

constexpr double length = 1e-3;  // of the step [s]

/// Falls from x0 with x' = field(x, mode), by the classical method of Runge and Kutta. It crosses where x is
/// 0.
struct Fall {
  double* numbers;  ///< time, x, x', mode: 1 above 0, else 0
  double (*field)(double x, double mode);
  int* steps;

  void advance(double from, double to, double h) const {
    ++*steps;
    const double x = numbers[1], m = numbers[3], a = field(x, m), b = field(x + 0.5 * h * a, m),
                 c = field(x + 0.5 * h * b, m), d = field(x + h * c, m);
    numbers[1] = x + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    numbers[0] = to;
    static_cast<void>(from);
  }
  void begin() const { numbers[2] = field(numbers[1], numbers[3]); }
  void crossings(double* at) const { at[0] = numbers[1]; }
  double edge() const { return 1e300; }
  bool failed() const { return false; }
  void forget_fault() const {}
  void follow() const {}
  void before(double) const {}
  void begin_event() const {}
  bool round() const {
    numbers[3] = numbers[1] > 0.0 ? 1.0 : 0.0;
    return false;
  }
  bool after() const { return false; }
};

struct Found {
  int steps;
  double events, x;  ///< x at the end of the step [1]
};

/// Takes one step from x0 at a time of the run.
Found step_from(double time, double x0, double (*field)(double x, double mode)) {
  std::vector<double> numbers(32, 0.0), scratch(64, 0.0);
  numbers[0] = time;
  numbers[1] = scratch[0] = scratch[2] = x0;
  numbers[3] = 1.0;
  solve::EventTask task{};
  task.states = task.crossing_count = task.state_count = task.first = 1;
  task.numbers = 3;
  task.derivatives = 2;
  task.report = 4;
  task.max_per_step = 50;
  task.rounds = 10;
  task.looks = 4;
  task.scratch = scratch.data();
  int steps = 0;
  const Fall fall{numbers.data(), field, &steps};
  solve::EventLocator(task, numbers.data(), fall).advance(time, time + length, length);
  return {steps, numbers[4], numbers[1]};
}

double with_jump(double, double mode) {
  return mode > 0.0 ? -1.0 : -0.2;
}
double with_bend(double x, double) {
  return -1.0 - 300.0 * std::abs(x);
}

}  // namespace

TEST_CASE("a crossing at which the field jumps is met to rounding, whatever its place in the step") {
  for (const double x0 : {1e-5, 1e-4, 3e-4, 5.2e-4, 9.9e-4}) {
    const Found found = step_from(0.0, x0, with_jump);
    CHECK(found.events == 1.0);
    CHECK(found.x == Approx(-0.2 * (length - x0)).margin(1e-15));
  }
}

// The end is that of x' = -1 - 300 |x|: ln(1 + 300 x0) / 300 seconds down, then by the same rule with -300 x.
TEST_CASE("a crossing at which the field bends is met with the accuracy of the solver") {
  for (const double x0 : {1e-5, 1e-4, 3e-4, 5.2e-4, 7e-4}) {
    const double crossed = std::log(1.0 + 300.0 * x0) / 300.0;
    const double end = (1.0 - std::exp(300.0 * (length - crossed))) / 300.0;
    const Found found = step_from(0.0, x0, with_bend);
    CHECK(found.events == 1.0);
    CHECK(found.x == Approx(end).epsilon(5e-4));  // a stage reads the far side of a bend, in the third order
  }
}

TEST_CASE("a crossing costs at most 10 steps at a jump of the field and 20 at a bend, late in a run, too") {
  for (const double time : {0.0, 10.0, 1000.0, 1e6})
    for (const double x0 : {1e-4, 3e-4, 5.2e-4, 7e-4}) {
      INFO(time << " s, from " << x0);
      CHECK(step_from(time, x0, with_bend).steps <= 20);
      CHECK(step_from(time, x0, with_jump).steps <= 10);
    }
}
