#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/model/block/outline.hpp"
#include "tests/blocks/haptics/region_rig.hpp"

using namespace stepwire;

namespace {

constexpr double mm = 1e-3;

/// Positive where the line runs counterclockwise.
double area_of(const Outline::Line& line) {
  double twice = 0.0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const auto &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

}  // namespace

TEST_CASE("The outline of a region runs along its boundary, with the region to the left") {
  const std::string shape = "{center: [3 mm, -2 mm], radius: 8 mm, inner_radius: 5 mm}";
  const Outline outline = RegionRig(shape).outline();
  REQUIRE(outline.lines.size() == 2);
  CHECK(area_of(outline.lines[0]) == Approx(64 * std::numbers::pi * mm * mm).epsilon(0.01));
  CHECK(area_of(outline.lines[1]) == Approx(-25 * std::numbers::pi * mm * mm).epsilon(0.01));
}

TEST_CASE("Every point of an outline lies on the boundary, and pieces of a boundary are one loop") {
  for (const std::string shape :
       {"{polygon: [[0 mm, 0 mm], [9 mm, 1 mm], [4 mm, 8 mm]]}",
        "{spline: [[0 mm, 0 mm], [9 mm, 4 mm], [14 mm, -8 mm], [22 mm, 0 mm]], half_width: 1.5 mm}",
        "{corridor: [[206 mm, -22 mm], [224 mm, -6 mm], [238 mm, 6.4444 mm], [224 mm, 20 mm]], half_width: 3 "
        "mm}",
        "{left: \"-8 mm + y^2/(90 mm)\", right: \"8 mm - y^2/(70 mm)\", y: [-9 mm, 19 mm]}",
        "{union: [{center: [0 mm, 0 mm], radius: 5 mm}, {center: [7 mm, 1 mm], radius: 4 mm}]}"}) {
    RegionRig region(shape);
    const Outline outline = region.outline();
    INFO(shape);
    REQUIRE(outline.lines.size() == 1);
    CHECK(area_of(outline.lines[0]) > 0.0);
    for (const auto& point : outline.lines[0].points)
      CHECK(region.at({point[0], point[1]}).distance == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("The outline of a sphere has its radius") {
  RegionRig region("{center: [0, 0, 0], radius: 8 mm}");
  const Outline outline = region.outline();
  CHECK(outline.space);
  REQUIRE(outline.lines.size() == 3);
  for (const Outline::Line& line : outline.lines)
    for (const auto& point : line.points) CHECK(std::hypot(point[0], point[1], point[2]) == Approx(8 * mm));
}
