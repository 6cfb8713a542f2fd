// A body of 1 kg with dry friction, against Newton's law.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire {

namespace {

/// Record: position, velocity, whether it slides. `push` is a block called push.
table::Table body(const std::string& events, const std::string& push, const std::string& friction,
                  const std::string& velocity = "0") {
  return run_text("events: " + events + R"(
step: 1 ms
stop: 3 s
solver: rk4
blocks:
  )" + push + R"(
  friction: {block: Friction, mass: 1 kg, )" +
                  friction + R"(, force: push, velocity: body.velocity}
  sum: {block: Sum, u: [push, friction.y]}
  body: {block: Mass, mass: 1 kg, force: sum, initial_velocity: )" +
                  velocity + R"( m/s}
record: {signals: [{x: body.position}, {v: body.velocity}, friction.slides]}
)");
}

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

}  // namespace

TEST_CASE("a body at rest stays at rest while what pushes it is weaker than its friction") {
  for (const char* events : {"tick", "locate"}) {
    const table::Table run =
        body(events, "push: {block: Sine, amplitude: 0.99 N, frequency: 3 Hz}", "coulomb: 1 N");
    for (const double x : column(run, "x")) CHECK(x == 0.0);
  }
}

TEST_CASE("a body that slides comes to rest where its energy is used up, and stays there") {
  for (const char* events : {"tick", "locate"}) {
    INFO(events);
    // 1/2 v^2 = 2 N/kg x, after v / 2 s; then 1.5 N push it in vain.
    const table::Table run =
        body(events, "push: {block: Step, time: 2 s, before: 0 N, after: -1.5 N}", "coulomb: 2 N", "1.7");
    CHECK(last(run, "x") == Approx(0.25 * 1.7 * 1.7).epsilon(std::string(events) == "tick" ? 1e-5 : 1e-9));
    CHECK(std::abs(last(run, "v")) < 1e-15);
    CHECK(last(run, "friction.slides") == 0.0);
  }
}

TEST_CASE("it takes more to move a body than to keep it moving") {
  for (const char* events : {"tick", "locate"}) {
    INFO(events);
    // The push rises by 1 N/s: at 1.5 s it breaks away, and then 1 N brakes it: v' = t - 1.
    const table::Table run =
        body(events, "push: {block: Ramp, slope: 1 N/s}", "coulomb: 1 N, breakaway: 1.5 N");
    CHECK(last(run, "v") ==
          Approx(0.5 * (2.0 * 2.0 - 0.5 * 0.5)).epsilon(std::string(events) == "tick" ? 2e-3 : 1e-9));
  }
}

TEST_CASE("a push that turns makes a body slide back") {
  // 3 N against 1 N for 1 s: 2 m/s; then -3 N and -1 N for 0.5 s down to 0, and 2 N drive it back.
  const table::Table run =
      body("locate", "push: {block: Step, time: 1 s, before: 3 N, after: -3 N}", "coulomb: 1 N");
  CHECK(last(run, "v") == Approx(-2.0 * 1.5).epsilon(1e-9));
  CHECK(last(run, "x") == Approx(1.0 + 0.5 - 1.5 * 1.5).epsilon(1e-9));
}

TEST_CASE("a body on a belt sticks and slips") {
  // A spring of 100 N/m drawn at 0.1 m/s: it sticks until the spring has 1.5 N, so first for 0.15 s.
  const table::Table run =
      body("locate",
           "push: {block: Expression, u: [belt, body.position], expression: \"100*(u1 - u2)\"}\n"
           "  belt: {block: Ramp, slope: 0.1}",
           "coulomb: 1 N, breakaway: 1.5 N");
  const auto &time = column(run, "time"), &slides = column(run, "friction.slides");
  std::vector<double> begins;
  for (std::size_t k = 1; k < slides.size(); ++k)
    if (slides[k] != 0.0 && slides[k - 1] == 0.0) begins.push_back(time[k]);
  REQUIRE(begins.size() > 4);
  CHECK(begins[0] == Approx(0.15).margin(1.1e-3));
  // v = 0.1 m/s (1 - cos w t) + 0.05 m/s sin w t with w = 10/s is 0 again after w t = 2 pi - 2 atan 0.5. The
  // spring force is then 0.5 N, and takes 1 N / (10 N/s) to reach 1.5 N again.
  const double slip = (2.0 * M_PI - 2.0 * std::atan(0.5)) / 10.0;
  for (std::size_t k = 1; k < begins.size(); ++k)
    CHECK(begins[k] - begins[k - 1] == Approx(slip + 0.1).margin(2.1e-3));
}

}  // namespace stepwire
