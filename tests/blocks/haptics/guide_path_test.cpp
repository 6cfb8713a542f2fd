#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double mm = 1e-3;

/// The pin goes from (20, 0) mm at 10 mm/s in the given direction; the region is the half plane x < 10 mm.
table::Table pushed(double degrees, const std::string& keys) {
  const double angle = degrees * 3.14159265358979323846 / 180.0;
  return run_text("step: 1 ms\nstop: 0.8 s\nblocks:\n  x: {block: Ramp, initial: 20 mm, slope: " +
                  std::to_string(10 * std::cos(angle)) +
                  " mm/s}\n  y: {block: Ramp, slope: " + std::to_string(10 * std::sin(angle)) +
                  " mm/s}\n  pin: {block: Mux, u: [x, y]}\n"
                  "  map: {block: Region, shape: {right: 10 mm, y: [-1 m, 1 m]}, position: pin}\n"
                  "  guide: {block: GuidePath, position: pin, nearest: map.nearest, distance: map.distance" +
                  keys +
                  ", every: 1 ms}\nrecord: [pin, map.distance, guide.error, guide.start, guide.target]\n");
}

}  // namespace

TEST_CASE("Along the path there is no resistance, and the region is reached") {
  for (const std::string renewal : {"none", "every_sample"}) {
    const table::Table run = pushed(180, ", renewal: " + renewal);
    for (const double error : column(run, "guide.error")) CHECK(error == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("A fixed path is eased within its width, and its side is as steep as told up to the distance") {
  const table::Table run = pushed(90, ", renewal: none, half_width: 1 mm, steepness: 5");
  for (std::size_t k = 0; k < run.rows(); ++k) {
    const double beside = std::max(0.0, column(run, "pin.2")[k] - 1 * mm);
    CHECK(column(run, "guide.error")[k] == Approx(std::min(10 * mm, 5 * beside)).margin(1e-12));
    CHECK(column(run, "guide.target.2")[k] == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("A path that takes away part of the resistance leaves the rest") {
  const table::Table run = pushed(180, ", renewal: none, easing: 0.75");
  for (std::size_t k = 0; k < run.rows(); ++k)
    CHECK(column(run, "guide.error")[k] == Approx(0.25 * column(run, "map.distance")[k]).margin(1e-12));
}

TEST_CASE("A renewed path starts as far behind the pin as its trail, and leads to what is nearest now") {
  const table::Table run = pushed(90, ", trail: 3 mm, half_width: 1 mm, steepness: 1");
  CHECK(column(run, "guide.start.2").back() == Approx(5 * mm).margin(0.02 * mm));
  CHECK(column(run, "guide.target.2").back() == Approx(8 * mm).margin(1e-9));
  // The way from (20, 5) to (10, 8) passes the pin at (20, 8) at a distance of 3 cos(atan(3/10)).
  const double beside = 3 * mm * 10.0 / std::hypot(10.0, 3.0) - 1 * mm;
  CHECK(column(run, "guide.error").back() == Approx(beside).epsilon(0.01));
}

TEST_CASE("A trail that is not longer than half of the width is refused") {
  CHECK_THAT(
      error_of("step: 1 s\nstop: 1 s\nblocks:\n  g: {block: GuidePath, position: [0, 0], nearest: [0, 0], "
               "distance: 0 m, half_width: 3 mm, trail: 2 mm}\n"),
      Catch::Contains("g.trail") && Catch::Contains("half width"));
}

TEST_CASE("A map is moved until the pin is in its region, once or at a trigger") {
  const std::string text = R"(
step: 0.1 s
stop: 1 s
blocks:
  x: {block: Ramp, initial: 20 mm, slope: 100 mm/s}
  pin: {block: Mux, u: [x, 0 m]}
  late: {block: Step, time: 0.5 s}
  map: {block: Region, shape: {center: [0 mm, 0 mm], radius: 8 mm}, position: to.shifted}
  to: {block: ReOrigin, position: pin, nearest: map.nearest, direction: map.direction, distance: map.distance,
       margin: 2 mm, every: 0.1 s)";
  const table::Table once = run_text(text + "}\nrecord: [map.distance, to.origin]\n");
  CHECK(column(once, "map.distance")[0] == Approx(12 * mm));
  CHECK(column(once, "map.distance")[1] == Approx(8 * mm));  // the pin went on by 10 mm
  for (std::size_t k = 1; k < once.rows(); ++k) CHECK(column(once, "to.origin.1")[k] == Approx(14 * mm));
  const table::Table late = run_text(text + ", trigger: late}\nrecord: [map.distance, to.origin]\n");
  CHECK(column(late, "to.origin.1")[5] == 0.0);
  for (std::size_t k = 6; k < late.rows(); ++k) CHECK(column(late, "to.origin.1")[k] == Approx(64 * mm));
}
