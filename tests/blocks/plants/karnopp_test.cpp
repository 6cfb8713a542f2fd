// Karnopp's friction against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire {

namespace {

/// Record: position, velocity, pseudo velocity and the mode. `push` is a block called push.
table::Table body(const std::string& events, const std::string& push, const std::string& friction,
                  const std::string& velocity = "0") {
  return run_text("events: " + events + R"(
step: 1 ms
stop: 3 s
solver: rk4
blocks:
  )" + push + R"(
  friction: {block: Karnopp, mass: 1 kg, )" +
                  friction + R"(, force: push, velocity: body.velocity}
  sum: {block: Sum, u: [push, friction.y]}
  body: {block: Mass, mass: 1 kg, force: sum, initial_velocity: )" +
                  velocity + R"( m/s}
record: {signals: [{x: body.position}, {v: body.velocity}, friction.pseudo, friction.slides]}
)");
}

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

}  // namespace

TEST_CASE("Karnopp's friction holds a body against any push below breakaway") {
  for (const char* events : {"tick", "locate"}) {
    const table::Table run = body(events, "push: {block: Sine, amplitude: 1.49 N, frequency: 3 Hz}",
                                  "coulomb: 1 N, breakaway: 1.5 N, band: 1 mm/s");
    for (const double x : column(run, "x")) CHECK(x == 0.0);
    for (const double v : column(run, "friction.pseudo")) CHECK(v == 0.0);
  }
}

TEST_CASE("Karnopp's friction stops a body that enters the band, for good") {
  for (const char* events : {"tick", "locate"}) {
    INFO(events);
    // 2 N/kg down to the band of 1 mm/s, whose rest is taken within a step.
    const table::Table run =
        body(events, "push: {block: Constant, value: 0 N}", "coulomb: 2 N, band: 1 mm/s", "1.7");
    CHECK(last(run, "x") == Approx(0.25 * 1.7 * 1.7).margin(1e-6));
    CHECK(std::abs(last(run, "v")) < 1e-15);
    CHECK(last(run, "friction.slides") == 0.0);
  }
}

TEST_CASE("a step that carries a body through a narrow band does not make Karnopp's friction chatter") {
  const table::Table run =
      body("tick", "push: {block: Constant, value: 0.5 N}", "coulomb: 2 N, band: 1e-9", "1.7");
  CHECK(last(run, "x") == Approx(1.7 * 1.7 / 3.0).margin(1e-5));
  CHECK(std::abs(last(run, "v")) < 1e-15);
}

TEST_CASE("a body on a belt sticks and slips with the period of Karnopp's model") {
  const double band = 1e-4, belt = 0.1, w = 10.0, stiffness = 100.0, drop = 0.5;
  const table::Table run =
      body("locate",
           "push: {block: Expression, u: [belt, body.position], expression: \"100*(u1 - u2)\"}\n"
           "  belt: {block: Ramp, slope: 0.1}",
           "coulomb: 1 N, breakaway: 1.5 N, band: 0.1 mm/s");
  // Within the band v = belt (1 - cos w t), up to the band; the spring has gained `more` by then.
  const double leaving = std::acos(1.0 - band / belt) / w;
  const double more = stiffness * belt * std::sin(w * leaving) / w;
  // Outside v - belt = (band - belt) cos w t + (drop + more) / w sin w t, back in the band after `slip`. The
  // spring then has 1 N - (drop + more), and gains 2 drop + more up to breakaway.
  const double slip = (2.0 * M_PI - 2.0 * std::atan((drop + more) / (w * (belt - band)))) / w;
  const double period = slip + (2.0 * drop + more) / (stiffness * belt) + leaving;
  const double first = 1.5 / (stiffness * belt) + leaving;
  const auto &time = column(run, "time"), &v = column(run, "v"), &slides = column(run, "friction.slides");
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double turns = std::floor((time[k] - first) / period), since = time[k] - first - turns * period;
    INFO(time[k]);
    if (turns < 0.0 || since > slip + 2e-3) {
      CHECK(std::abs(v[k]) < band);
      if (since < period - 1e-4) CHECK(slides[k] == 0.0);
    } else if (since > 1e-4 && since < slip - 1e-4) {
      CHECK(slides[k] == 1.0);
      CHECK(v[k] ==
            Approx(belt + (band - belt) * std::cos(w * since) + (drop + more) / w * std::sin(w * since))
                .margin(5e-6));
    }
  }
}

TEST_CASE("dry friction lets a body that is thrown back slide on") {
  // From 1.7 m/s, thrown back with half of its speed at 1 m: v^2 = 1.7^2 - 2, then 0.5 v with 1 N/kg.
  const double speed = 0.5 * std::sqrt(1.7 * 1.7 - 2.0);
  for (const char* friction : {"block: Friction", "block: Karnopp, band: 0.1 mm/s"}) {
    INFO(friction);
    const table::Table run = run_text(std::string(R"(
step: 1 ms
stop: 3 s
solver: rk4
events: locate
blocks:
  none: {block: Constant, value: 0 N}
  wall: {block: HardStop, mass: 1 kg, upper: 1 m, restitution: 0.5, force: friction.y,
         position: body.position, velocity: body.velocity}
  friction: {)") + friction + R"(, mass: 1 kg, coulomb: 1 N, force: none, velocity: body.velocity}
  sum: {block: Sum, u: [friction.y, wall.y]}
  body: {block: Mass, mass: 1 kg, force: sum, initial_velocity: 1.7 m/s, reset: wall.hit, value: wall.rebound}
record: [body.position]
)");
    CHECK(last(run, "body.position") == Approx(1.0 - 0.5 * speed * speed).margin(1e-6));
  }
}

}  // namespace stepwire
