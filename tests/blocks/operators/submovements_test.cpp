#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

double minimum_jerk(double s) {
  return s >= 1.0 ? 1.0 : s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

/// Pieces every 0.3 s of 0.45 s, of a hand at `position`.
table::Table moved(const std::string& step, const std::string& position, const std::string& keys = "",
                   const std::string& stop = "3 s") {
  return run_text("step: 10 ms\nstop: " + stop + "\nblocks:\n  m: {block: Submovements, step: " + step +
                  ", position: " + position + ", interval: 0.3 s, overlap: 1.5, every: 10 ms" + keys +
                  "}\nrecord: [m.equilibrium, m.velocity, m.pending, m.begins]\n");
}

/// The last via point along an axis.
double goal(const table::Table& run, const std::string& axis, std::size_t k) {
  return column(run, "m.equilibrium." + axis)[k] + column(run, "m.pending." + axis)[k];
}

}  // namespace

TEST_CASE("A piece goes to its via point in minimum jerk, and the next adds to it") {
  const table::Table run = moved("[6 mm, -2 mm]", "[0 mm, 0 mm]", "", "0.59 s");
  const auto &x = column(run, "m.equilibrium.1"), &y = column(run, "m.equilibrium.2"),
             &time = column(run, "time");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double second = time[k] < 0.3 ? 0.0 : minimum_jerk((time[k] - 0.3) / 0.45);
    const double way = minimum_jerk(time[k] / 0.45) + second;
    REQUIRE(x[k] == Approx(6e-3 * way).margin(1e-12));
    REQUIRE(y[k] == Approx(-2e-3 * way).margin(1e-12));
  }
}

TEST_CASE("The velocity is the slope of the equilibrium, and pending what is left") {
  const table::Table run = moved("[6 mm, 0 mm]", "[0 mm, 0 mm]");
  const auto &x = column(run, "m.equilibrium.1"), &v = column(run, "m.velocity.1");
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    REQUIRE(v[k] == Approx((x[k + 1] - x[k - 1]) / 0.02).margin(2e-4));
  CHECK(column(run, "m.pending.1")[30] == Approx(6e-3 * (1.0 - minimum_jerk(2.0 / 3.0))));
}

TEST_CASE("Twice the step doubles the speed and leaves the duration of the pieces") {
  const table::Table slow = moved("[3 mm, 0 mm]", "[0 mm, 0 mm]"),
                     fast = moved("[6 mm, 0 mm]", "[0 mm, 0 mm]");
  CHECK(column(slow, "m.begins") == column(fast, "m.begins"));
  const auto &a = column(slow, "m.velocity.1"), &b = column(fast, "m.velocity.1");
  for (std::size_t k = 0; k < a.size(); ++k) REQUIRE(b[k] == Approx(2.0 * a[k]).margin(1e-12));
}

TEST_CASE("The first piece waits for the latency") {
  const table::Table run = moved("[3 mm, 0 mm]", "[0 mm, 0 mm]", ", latency: 0.5 s");
  CHECK(column(run, "m.equilibrium.1")[50] == 0.0);
  CHECK(column(run, "m.equilibrium.1")[60] > 0.0);
}

TEST_CASE("A hand that is held is led no farther than the reach") {
  const table::Table run = moved("[3 mm, 4 mm]", "[0 mm, 0 mm]", ", reach: 20 mm", "20 s");
  CHECK(std::hypot(column(run, "m.equilibrium.1").back(), column(run, "m.equilibrium.2").back()) ==
        Approx(20e-3));
}

TEST_CASE("What is behind across the new direction is given up, what is behind along it is not") {
  // 2 s along x, then along y, by a hand that is held
  const table::Table run = run_text(R"(
step: 10 ms
stop: 6 s
blocks:
  x: {block: Step, time: 2.05 s, before: 3 mm, after: 0 mm}
  y: {block: Step, time: 2.05 s, before: 0 mm, after: 3 mm}
  step: {block: Mux, u: [x, y]}
  m: {block: Submovements, step: step, position: [0 mm, 0 mm], interval: 0.3 s, overlap: 1.5, hold: 0.5 s, every: 10 ms}
record: [m.equilibrium, m.pending]
)");
  CHECK(goal(run, "1", 205) == Approx(7 * 3e-3));                        // pieces at 0, 0.3, ... 1.8 s
  CHECK(goal(run, "1", 515) == Approx(7 * 3e-3 * std::exp(-11 * 0.6)));  // 11 more until 5.1 s
  CHECK(goal(run, "2", 515) == Approx(11 * 3e-3));
}

TEST_CASE(
    "A push against what does not give way grows as long as the correction is there, and then is given up") {
  // A held hand goes along x; until 3.05 s an error is corrected by 1 mm along y.
  const table::Table run = run_text(R"(
step: 10 ms
stop: 6 s
blocks:
  y: {block: Step, time: 3.05 s, before: 1 mm, after: 0 mm}
  step: {block: Mux, u: [3 mm, y]}
  right: {block: Mux, u: [0 mm, y]}
  m: {block: Submovements, step: step, correction: right, position: [0 mm, 0 mm], interval: 0.3 s, overlap: 1.5, hold: 0.5 s, every: 10 ms}
record: [m.equilibrium, m.pending]
)");
  // Eleven pieces until 3.0 s; without a correction the lead along y would end at 1 mm/(1 - exp(-0.6)) = 2.2
  // mm.
  CHECK(goal(run, "2", 304) == Approx(11e-3).epsilon(0.02));
  // Nine more until 5.7 s, of which each leaves exp(-0.6).
  CHECK(goal(run, "2", 599) == Approx(11e-3 * std::exp(-9 * 0.6)).epsilon(0.02));
}

TEST_CASE("A hand that is led beyond the reach is let go within the reflex") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 0.5 s
blocks:
  far:  {block: Step, time: 50 ms, before: 30 mm, after: 10 mm}
  m: {block: Submovements, step: [30 mm, 0 mm], position: [0 mm, 0 mm], reach: far, interval: 10 s, overlap: 1, reflex: 50 ms, every: 1 ms}
record: [m.equilibrium, m.pending]
)");
  CHECK(goal(run, "1", 50) == Approx(30e-3));
  for (const std::size_t k : {100u, 150u, 300u})
    CHECK(goal(run, "1", k) ==
          Approx(10e-3 + 20e-3 * std::exp(-static_cast<double>(k - 50) / 50.0)).epsilon(0.02));
}

TEST_CASE("A hand without any reach that is where it is led stays a number") {
  const table::Table run = moved("[0 mm, 0 mm]", "[0 mm, 0 mm]", ", reach: -1 mm, reflex: 50 ms", "2 s");
  CHECK(column(run, "m.equilibrium.1").back() == 0.0);
}
