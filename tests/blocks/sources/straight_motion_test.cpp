#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const table::Table& smooth_start() {
  static const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  push:  {block: StraightMotion, from: [1, 2, 3], direction: [2, -1, 2], speed: 3 m/s, rise: 0.5 s, start: 0.25 s}
  speed: {block: Integrator, u: push.acceleration}
  place: {block: Integrator, u: push.velocity}
record: [push.position, push.velocity, push.acceleration, push.distance, speed, place]
)");
  return table;
}

}  // namespace

TEST_CASE("A straight motion rests, then goes on at its speed along its direction") {
  const table::Table& table = smooth_start();
  CHECK(column(table, "push.distance")[250] == 0.0);
  CHECK(column(table, "push.velocity.1")[250] == 0.0);
  CHECK(column(table, "push.distance").back() == Approx(3.0 * (2.0 - 0.25 - 0.25)).epsilon(1e-12));
  CHECK(column(table, "push.position.1").back() == Approx(1.0 + 4.5 * 2.0 / 3.0).epsilon(1e-12));
  CHECK(column(table, "push.position.2").back() == Approx(2.0 - 4.5 / 3.0).epsilon(1e-12));
  CHECK(column(table, "push.velocity.3").back() == Approx(2.0).epsilon(1e-12));
  CHECK(column(table, "push.acceleration.3").back() == 0.0);
}

TEST_CASE("Velocity and acceleration of a straight motion are its derivatives") {
  const table::Table& table = smooth_start();
  for (const std::string i : {".1", ".2", ".3"}) {
    const auto &position = column(table, "push.position" + i), &place = column(table, "place" + i);
    const auto &velocity = column(table, "push.velocity" + i), &speed = column(table, "speed" + i);
    for (std::size_t k = 0; k < place.size(); k += 10) {
      CHECK(position[k] - position[0] == Approx(place[k]).margin(1e-9));
      CHECK(velocity[k] == Approx(speed[k]).margin(1e-9));
    }
  }
}

TEST_CASE("Halfway through its rise a straight motion has half its speed and its largest acceleration") {
  const table::Table& table = smooth_start();
  CHECK(column(table, "push.velocity.1")[500] == Approx(1.0).epsilon(1e-12));
  CHECK(column(table, "push.acceleration.1")[500] ==
        Approx(2.0 * std::numbers::pi / 2.0 / 0.5).epsilon(1e-12));
}

TEST_CASE("A straight motion without rise moves at once") {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 1 s\nblocks:\n  push: {block: StraightMotion, speed: -2 m/s}\nrecord: "
      "[push.position, push.velocity]\n");
  CHECK(column(table, "push.velocity").front() == -2.0);
  CHECK(column(table, "push.position").back() == -2.0);
}

TEST_CASE("A straight motion without direction is refused") {
  const auto error = [](const std::string& keys) {
    return error_of("step: 1 ms\nstop: 1 s\nblocks:\n  push: {block: StraightMotion, " + keys + "}\n");
  };
  CHECK_THAT(error("from: [0, 0], direction: [0, 0]"), Catch::Contains("push.direction"));
  CHECK_THAT(error("from: [0, 0], direction: [1, 0, 0]"), Catch::Contains("push.from"));
}

TEST_CASE("A turn is added to the angle of a straight motion in the plane") {
  const table::Table table = run_text(R"yaml(
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  turned: {block: StraightMotion, from: [1, 2], direction: [3, 4], speed: 2 m/s, rise: 0.1 s, turn: 40 deg}
  angle:  {block: StraightMotion, from: [1, 2], direction: ["= cos(atan2(4, 3) + 40 deg)", "= sin(atan2(4, 3) + 40 deg)"],
           speed: 2 m/s, rise: 0.1 s}
record: [turned.position, turned.velocity, turned.acceleration, angle.position, angle.velocity, angle.acceleration]
)yaml");
  for (const std::string what :
       {"position.1", "position.2", "velocity.1", "velocity.2", "acceleration.1", "acceleration.2"})
    for (std::size_t k = 0; k < table.rows(); ++k)
      CHECK(column(table, "turned." + what)[k] == Approx(column(table, "angle." + what)[k]).margin(1e-12));
}

TEST_CASE("A turn is refused where a straight motion is not in the plane") {
  CHECK_THAT(error_of("step: 1 ms\nstop: 1 s\nblocks: {a: {block: StraightMotion, from: [0, 0, 0], "
                      "direction: [1, 0, 0], turn: 0.1}}\n"),
             Catch::Matchers::Contains("a direction in the plane"));
}
