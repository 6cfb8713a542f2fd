#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// The step that is planned from (x, y), about (3, 4) with radius 2 and a correction of 4 Hz every 0.3 s.
std::pair<double, double> step_from(const std::string& x, const std::string& y, const std::string& speed,
                                    const std::string& pending = "[0 m, 0 m]") {
  const table::Table run = run_text(
      "step: 1 s\nstop: 1 s\nblocks:\n  plan: {block: CirclePlan, position: [" + x + ", " + y +
      "], pending: " + pending + ", center: [3 m, 4 m], speed: " + speed +
      ", interval: 0.3 s, radius: 2 m, correction: 4 Hz, every: 1 s}\nrecord: [plan.step, plan.off]\n");
  return {column(run, "plan.step.1").front(), column(run, "plan.step.2").front()};
}

}  // namespace

TEST_CASE("The next via point lies farther along the circle by the way of an interval") {
  const auto [x, y] = step_from("5 m", "4 m", "1 m/s");
  CHECK(x == Approx(2.0 * (std::cos(0.15) - 1.0)));
  CHECK(y == Approx(2.0 * std::sin(0.15)));
}

TEST_CASE("Of a radial error exp(-correction interval) is left at the next via point") {
  CHECK(step_from("7 m", "4 m", "0 m/s").first == Approx(2.0 * (std::exp(-1.2) - 1.0)));
}

TEST_CASE("What the movements under way will add is taken for done") {
  const auto [x, y] = step_from("5 m", "4 m", "0 m/s", "[2 m, 0 m]");
  CHECK(x == Approx(2.0 * (std::exp(-1.2) - 1.0)));
  CHECK(y == Approx(0.0).margin(1e-12));
}

TEST_CASE("A point that follows the plan goes around, and turns are counted beyond the first") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 30 s
blocks:
  p:    {block: UnitDelay, u: next, initial: [5 m, 4 m], every: 0.1 s}
  next: {block: Sum, u: [p, plan.step], every: 0.1 s}
  plan: {block: CirclePlan, position: p, pending: [0 m, 0 m], center: [3 m, 4 m], speed: 1 m/s, interval: 0.1 s, radius: 2 m,
         correction: 4 Hz, every: 0.1 s}
record: [plan.turned, plan.off]
)");
  const auto &turned = column(run, "plan.turned"), &time = column(run, "time");
  for (std::size_t k = 0; k < time.size(); ++k) REQUIRE(turned[k] == Approx(time[k] / 2.0).margin(1e-9));
  CHECK(turned.back() > 4.0 * M_PI);
  CHECK(column(run, "plan.off").back() == Approx(0.0).margin(1e-12));
}

TEST_CASE("In the centre the plan is finite") {
  const auto [x, y] = step_from("3 m", "4 m", "1 m/s");
  CHECK(std::isfinite(x));
  CHECK(std::isfinite(y));
}
