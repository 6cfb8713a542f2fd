#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table pushed(const std::string& parameters, const std::string& stop) {
  return run_text("step: 1 ms\nstop: " + stop + "\nsolver: rk4\nblocks:\n  motor: {block: Pusher, " +
                  parameters +
                  R"(}
  way:   {block: Integrator, u: motor.velocity, initial: [10 mm, 0 mm]}
  speed: {block: Integrator, u: motor.acceleration, initial: [0 m/s, 0 m/s]}
record: [motor.position, motor.velocity, motor.acceleration, motor.distance, motor.leg, way, speed]
)");
}

}  // namespace

TEST_CASE("A pusher reaches its speed evenly, holds it and stops at the point") {
  // 1 s to reach 10 mm/s with 10 mm/s2, over 5 mm; 20 mm at that speed take 2 s; 5 mm to stop.
  const table::Table table = pushed(
      "points: [[10 mm, 0 mm], [10 mm, 30 mm]], speed: 10 mm/s, highest_acceleration: 0.01 m/s2", "5 s");
  const auto &y = column(table, "motor.position.2"), &v = column(table, "motor.velocity.2");
  CHECK(y[500] == Approx(1.25e-3));
  CHECK(v[500] == Approx(5e-3));
  CHECK(y[1000] == Approx(5e-3));
  CHECK(v[2000] == Approx(10e-3));
  CHECK(y[3000] == Approx(25e-3));
  CHECK(v[3500] == Approx(5e-3));
  CHECK(y[4000] == Approx(30e-3));
  CHECK(v.back() == 0.0);
  CHECK(column(table, "motor.distance").back() == Approx(30e-3));
}

TEST_CASE(
    "Position and velocity of a pusher are the integrals of what it gives beside them, round corners too") {
  const table::Table table = pushed(
      "points: [[10 mm, 0 mm], [40 mm, 0 mm], [40 mm, 0.1 mm], [10 mm, -40 mm]], speed: 20 mm/s", "5 s");
  for (const std::string i : {".1", ".2"})
    for (std::size_t k = 0; k < column(table, "time").size(); ++k) {
      REQUIRE(std::abs(column(table, "motor.position" + i)[k] - column(table, "way" + i)[k]) < 5e-5);
      REQUIRE(std::abs(column(table, "motor.velocity" + i)[k] - column(table, "speed" + i)[k]) < 2e-3);
    }
  CHECK(column(table, "motor.position.1").back() == Approx(10e-3));
  CHECK(column(table, "motor.position.2").back() == Approx(-40e-3));
  CHECK(column(table, "motor.leg").back() == 3.0);
}

TEST_CASE("A speed that is never reached makes a push of constant acceleration") {
  const table::Table table =
      pushed("points: [[10 mm, 0 mm], [30 mm, 0 mm]], speed: 1 m/s, highest_acceleration: 0.02 m/s2", "2 s");
  // half of the way in sqrt(20 mm / 0.02 m/s2) = 1 s
  CHECK(column(table, "motor.position.1")[1000] == Approx(20e-3));
  CHECK(column(table, "motor.velocity.1")[1000] == Approx(20e-3));
  CHECK(column(table, "motor.acceleration.1")[999] == Approx(0.02));
  CHECK(column(table, "motor.acceleration.1")[1001] == Approx(-0.02));
  CHECK(column(table, "motor.position.1").back() == Approx(30e-3));
}

TEST_CASE("A pusher rests until it begins") {
  const table::Table table = pushed("points: [[10 mm, 0 mm], [30 mm, 0 mm]], begin: 0.5 s", "1 s");
  CHECK(column(table, "motor.acceleration.1")[499] == 0.0);
  CHECK(column(table, "motor.position.1")[500] == 10e-3);
  CHECK(column(table, "motor.velocity.1")[600] > 0.0);
}

TEST_CASE("Points that give no way are refused") {
  const auto refused = [](const std::string& points) {
    return error_of("step: 1 ms\nstop: 1 s\nblocks:\n  motor: {block: Pusher, points: " + points + "}\n");
  };
  CHECK_THAT(refused("[[1 mm, 2 mm]]"), Catch::Contains("motor.points") && Catch::Contains("two or more"));
  CHECK_THAT(refused("[[1 mm, 2 mm], [1 mm, 2 mm]]"),
             Catch::Contains("motor.points") && Catch::Contains("point 2 lies where point 1 does"));
}
