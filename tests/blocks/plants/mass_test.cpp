#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A mass under a constant force moves on a parabola") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  mass: {block: Mass, force: 3 N, mass: 2 kg, initial_position: 0.5 m, initial_velocity: -1 m/s}
record: [mass.position, mass.velocity]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 100) {
    const double t = time[k];
    CHECK(column(table, "mass.position")[k] == Approx(0.5 - t + 0.75 * t * t).margin(1e-12));
    CHECK(column(table, "mass.velocity")[k] == Approx(-1.0 + 1.5 * t).margin(1e-12));
  }
}

TEST_CASE("A mass without inertia is refused") {
  CHECK_THAT(
      error_of("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  m: {block: Mass, force: 1 N, mass: 0 kg}\n"),
      Catch::Contains("m.mass") && Catch::Contains("above 0"));
}
