#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A radial and a tangential part turn into x and y at their angle, and back") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
blocks:
  angle: {block: Ramp, initial: -4 rad, slope: 8 rad/s}
  plane: {block: Rotate, u: [3 N, -2 N], angle: angle}
  polar: {block: Rotate, u: plane, angle: angle, inverse: true}
record: [angle, plane, polar]
)");
  for (std::size_t k = 0; k < column(table, "time").size(); ++k) {
    const double at = column(table, "angle")[k], c = std::cos(at), s = std::sin(at);
    CHECK(column(table, "plane.1")[k] == Approx(3.0 * c + 2.0 * s).margin(1e-14));
    CHECK(column(table, "plane.2")[k] == Approx(3.0 * s - 2.0 * c).margin(1e-14));
    CHECK(column(table, "polar.1")[k] == Approx(3.0).epsilon(1e-14));
    CHECK(column(table, "polar.2")[k] == Approx(-2.0).epsilon(1e-14));
  }
}
