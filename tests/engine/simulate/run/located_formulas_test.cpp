// Jumps and bends of formulas, against integrals that are known.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// The integral of a formula of x = 3.3 (t - 0.53) from 0 to 1 s, in steps of 0.1 s.
double integral(const std::string& formula, const std::string& events = "locate") {
  const table::Table run = run_text("events: " + events + R"(
step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: 3.3, initial: -1.749}
  y: {block: Expression, u: x, variables: [x], expression: ")" +
                                    formula + R"("}
  sum: {block: Integrator, u: y}
record: [sum]
)");
  return column(run, "sum").back();
}

/// The integral over x from -1.749 to 1.551, by its antiderivative between the places where it breaks.
double exact(double (*formula)(double), const std::vector<double>& breaks) {
  double sum = 0.0, from = -1.749;
  for (std::size_t i = 0; i <= breaks.size(); ++i) {
    const double to = i < breaks.size() ? breaks[i] : 1.551, middle = 0.5 * (from + to);
    sum += (to - from) * (formula(from + 1e-12) + 4.0 * formula(middle) + formula(to - 1e-12)) / 6.0;
    from = to;
  }
  return sum / 3.3;
}

}  // namespace

TEST_CASE("steps and bends of a formula are located") {
  CHECK(integral("sign(x)") ==
        Approx(exact([](double x) { return x > 0.0 ? 1.0 : -1.0; }, {0.0})).margin(1e-10));
  CHECK(integral("abs(x)") == Approx(exact([](double x) { return std::abs(x); }, {0.0})).margin(1e-10));
  CHECK(integral("floor(x)") ==
        Approx(exact([](double x) { return std::floor(x); }, {-1.0, 0.0, 1.0})).margin(1e-10));
  CHECK(integral("ceil(x)") ==
        Approx(exact([](double x) { return std::ceil(x); }, {-1.0, 0.0, 1.0})).margin(1e-10));
  CHECK(integral("round(x)") ==
        Approx(exact([](double x) { return std::round(x); }, {-1.5, -0.5, 0.5, 1.5})).margin(1e-10));
  CHECK(integral("min(x, 0.2)") ==
        Approx(exact([](double x) { return std::min(x, 0.2); }, {0.2})).margin(1e-10));
  CHECK(integral("min(max(x, -0.7), 0.4)") ==
        Approx(exact([](double x) { return std::clamp(x, -0.7, 0.4); }, {-0.7, 0.4})).margin(1e-10));
  CHECK(integral("2*floor(x) - 3*sign(x - 0.31)") ==
        Approx(exact([](double x) { return 2.0 * std::floor(x) - 3.0 * (x > 0.31 ? 1.0 : -1.0); },
                     {-1.0, 0.0, 0.31, 1.0}))
            .margin(1e-10));
}

TEST_CASE("at ticks a formula sees nothing between them") {
  CHECK(std::abs(integral("sign(x)", "tick") - integral("sign(x)")) > 1e-3);
}

}  // namespace stepwire::run
