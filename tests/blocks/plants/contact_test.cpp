// Stops, and friction that yields, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire {

namespace {

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

std::string ball_text(const std::string& events, const std::string& stop, const std::string& start) {
  return "events: " + events + R"(
step: 1 ms
stop: 6 s
solver: rk4
blocks:
  weight: {block: Constant, value: -9.81 N}
  floor: {block: HardStop, mass: 1 kg, lower: 0 m, force: weight, position: ball.position, velocity: ball.velocity, )" +
         stop + R"(}
  sum: {block: Sum, u: [weight, floor.y]}
  ball: {block: Mass, mass: 1 kg, force: sum, reset: floor.hit, value: floor.rebound, initial_position: )" +
         start + R"(}
record: [ball.position, ball.velocity, floor.rests, floor.y]
)";
}

table::Table ball(const std::string& events, const std::string& stop, const std::string& start = "1 m") {
  return run_text(ball_text(events, stop, start));
}

/// Height of a ball of 1 m with restitution 0.8 at a time, before it rests.
double height(double time) {
  const double g = 9.81;
  double speed = std::sqrt(2.0 * g), left = time - std::sqrt(2.0 / g);
  if (left < 0.0) return 1.0 - 0.5 * g * time * time;
  for (speed *= 0.8; left > 2.0 * speed / g; speed *= 0.8) left -= 2.0 * speed / g;
  return speed * left - 0.5 * g * left * left;
}

}  // namespace

TEST_CASE("a body that is pressed on a stop rests there from the first instant") {
  for (const char* events : {"tick", "locate"})
    for (const char* solver : {"euler", "rk4"})
      for (const char* side : {"lower", "upper"}) {
        INFO(events << ' ' << solver << ' ' << side);
        const double into = side == std::string("lower") ? -10.0 : 10.0;
        const table::Table run =
            run_text(std::string("step: 10 ms\nstop: 1 s\nsolver: ") + solver + "\nevents: " + events +
                     "\nblocks:\n  f: {block: Constant, value: " + std::to_string(into) +
                     " N}\n  h: {block: HardStop, mass: 1 kg, " + side +
                     R"(: 0 m, restitution: 0.9, force: f, position: m.position, velocity: m.velocity}
  t: {block: Sum, u: [f, h.y]}
  m: {block: Mass, mass: 1 kg, force: t, reset: h.hit, value: h.rebound}
record: [m.position, m.velocity, h.rests, h.y, h.hit]
)");
        for (std::size_t k = 0; k < run.rows(); ++k) {
          CHECK(column(run, "h.y")[k] == -into);
          CHECK(column(run, "h.rests")[k] == (into < 0.0 ? -1.0 : 1.0));
          CHECK(column(run, "h.hit")[k] == 0.0);
          CHECK(column(run, "m.position")[k] == 0.0);
          CHECK(column(run, "m.velocity")[k] == 0.0);
        }
      }
}

TEST_CASE(
    "a ball bounces on a stop where its closed form has it, and then rests with the force of its weight") {
  const table::Table run = ball("locate", "restitution: 0.8, slow: 1e-4 m/s");
  const auto &time = column(run, "time"), &x = column(run, "ball.position");
  for (std::size_t k = 0; k < x.size(); ++k)
    if (time[k] < 3.9) CHECK(x[k] == Approx(height(time[k])).margin(1e-8));
  CHECK(std::abs(last(run, "ball.position")) < 1e-6);
  CHECK(std::abs(last(run, "ball.velocity")) < 1e-12);
  CHECK(last(run, "floor.rests") == -1.0);
  CHECK(last(run, "floor.y") == Approx(9.81).epsilon(1e-9));
}

TEST_CASE("a body that begins beyond a stop ends the run with a sentence") {
  CHECK_NOTHROW(ball("tick", "restitution: 0.5", "0 m"));
  for (const char* events : {"tick", "locate"})
    CHECK_THAT(error_of(ball_text(events, "restitution: 0.5", "-0.1 m")),
               Catch::Contains("floor") && Catch::Contains("begins beyond a stop"));
}

TEST_CASE("a ball that is not thrown back lies where it has fallen") {
  for (const char* events : {"tick", "locate"}) {
    INFO(events);
    const table::Table run = ball(events, "restitution: 0");
    CHECK(std::abs(last(run, "ball.position")) < (std::string(events) == "tick" ? 5e-3 : 1e-9));
    CHECK(std::abs(last(run, "ball.velocity")) < 1e-12);
  }
}

TEST_CASE("no bounce is too weak for a stop that keeps to ticks") {
  for (const char* restitution : {"0.5", "0.8", "0.95"})
    for (const char* events : {"tick", "locate"})
      for (const char* start : {"1 m", "0 m", "-1e-12 m"}) {
        INFO(restitution << " " << events << " " << start);
        const std::string keys = std::string("restitution: ") + restitution;
        const table::Table run = ball(events, keys, start);
        for (const double x : column(run, "ball.position")) REQUIRE(x > -0.01);
        if (std::string(restitution) != "0.95") CHECK(std::abs(last(run, "ball.velocity")) < 1e-6);
      }
}

TEST_CASE("a body that begins at a stop with a speed into it is thrown back") {
  const table::Table run = run_text(R"(step: 1 ms
stop: 1 s
solver: rk4
blocks:
  none: {block: Constant, value: 0 N}
  wall: {block: HardStop, mass: 1 kg, lower: 0 m, restitution: 0.5, force: none, position: m.position, velocity: m.velocity}
  m: {block: Mass, mass: 1 kg, force: wall.y, reset: wall.hit, value: wall.rebound, initial_velocity: -1 m/s}
record: [m.velocity]
)");
  CHECK(last(run, "m.velocity") == Approx(0.5));
}

TEST_CASE("a body that rests at a stop leaves it when it is pulled away") {
  const table::Table run = run_text(R"(events: locate
step: 10 ms
stop: 3 s
solver: rk4
blocks:
  push: {block: Ramp, slope: -1 N/s, initial: 1.005 N}
  wall: {block: HardStop, mass: 1 kg, upper: 0 m, force: push, position: body.position, velocity: body.velocity}
  sum: {block: Sum, u: [push, wall.y]}
  body: {block: Mass, mass: 1 kg, force: sum, reset: wall.hit, value: wall.rebound, initial_velocity: 1e-6 m/s}
record: [body.velocity]
)");
  // From 1.005 s on v' = -(t - 1.005).
  CHECK(last(run, "body.velocity") == Approx(-0.5 * 1.995 * 1.995).epsilon(1e-9));
}

TEST_CASE("bristles that move steadily give the friction of their speed") {
  // Canudas de Wit et al. 1995, equation 6: F = g(v) + viscous v.
  for (const double v : {0.0005, 0.001, 0.01, 0.1}) {
    INFO(v);
    const table::Table run =
        run_text("step: 0.1 ms\nstop: 1 s\nsolver: rosenbrock\nblocks:\n  v: {block: Constant, value: " +
                 std::to_string(v) + " m/s}\n  f: {block: LuGre, velocity: v}\nrecord: [f]\n");
    const double level = 1.0 + 0.5 * std::exp(-std::pow(v / 1e-3, 2.0));
    CHECK(last(run, "f") == Approx(-(level + 0.4 * v)).epsilon(1e-6));
  }
}

TEST_CASE("bristles hold what is weaker than their breakaway, but for their bend") {
  const table::Table run = run_text(R"(step: 0.05 ms
stop: 1 s
solver: rk4
blocks:
  push: {block: Constant, value: 0.8 N}
  friction: {block: LuGre, velocity: body.velocity}
  sum: {block: Sum, u: [push, friction]}
  body: {block: Mass, mass: 1 kg, force: sum}
record: [body.position, body.velocity]
)");
  CHECK(last(run, "body.position") > 0.8 / 1e5);
  CHECK(last(run, "body.position") < 4e-5);
  CHECK(std::abs(last(run, "body.velocity")) < 1e-9);
}

TEST_CASE("Dahl's spring yields with the way as its closed form has it") {
  for (const double v : {0.001, 0.02}) {
    const double stop = 2e-5 / v;
    const table::Table run =
        run_text("step: " + std::to_string(stop / 20.0) + " s\nstop: " + std::to_string(stop) +
                 " s\nsolver: rk4\nblocks:\n  v: {block: Constant, value: " + std::to_string(v) +
                 " m/s}\n  f: {block: Dahl, velocity: v}\nrecord: [f]\n");
    CHECK(last(run, "f") == Approx(-(1.0 - std::exp(-2.0))).epsilon(1e-6));
  }
}

}  // namespace stepwire
