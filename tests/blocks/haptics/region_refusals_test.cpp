#include <catch2/catch.hpp>

#include "tests/blocks/haptics/region_rig.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;
using Catch::Contains;

namespace {

void check_refused(const std::string& shape, const std::string& why) {
  INFO(shape);
  CHECK_THAT(refusal_of(shape), Contains("test.yaml:6:") && Contains("map.shape: ") && Contains(why));
}

}  // namespace

TEST_CASE("Boundaries that cross are refused with the height and by how much") {
  check_refused("{left: -6 mm, right: \"10 mm - y\", y: [0 mm, 18 mm]}", "the left boundary is");
  check_refused("{left: -6 mm, right: \"10 mm - y\", y: [0 mm, 18 mm]}", "end y where they do");
  CHECK(refusal_of("{left: -6 mm, right: \"10 mm - y\", y: [0 mm, 16 mm]}").empty());
}

TEST_CASE("A shape that leaves nothing is refused") {
  check_refused("{left: 2 mm, right: 2 mm, y: [0 mm, 10 mm]}", "the region is empty");
  check_refused("{center: [0 mm, 0 mm], radius: 0 mm}", "radius: 0 mm leaves nothing; it must be above 0");
  check_refused("{center: [0 mm, 0 mm], radius: 3 mm, inner_radius: 3 mm}", "below the radius of 3 mm");
  check_refused("{corridor: [[0 mm, 0 mm], [9 mm, 0 mm]], half_width: -1 mm}", "half_width: -1 mm");
  check_refused("{polygon: [[0 mm, 0 mm], [9 mm, 0 mm], [4 mm, 0 mm]]}", "corner");
}

TEST_CASE("A polygon that crosses itself is refused") {
  check_refused("{polygon: [[0 mm, 0 mm], [9 mm, 9 mm], [9 mm, 0 mm], [0 mm, 9 mm]]}",
                "crosses or touches itself");
}

TEST_CASE("A corridor that comes back to itself is refused, one that only bends is not") {
  const std::string hairpin = "[[0 mm, 0 mm], [20 mm, 0 mm], [20 mm, 3 mm], [0 mm, 3 mm]]";
  check_refused("{corridor: " + hairpin + ", half_width: 1.6 mm}", "it touches itself: near ");
  check_refused("{corridor: " + hairpin + ", half_width: 1.6 mm}", "more than its width of 3.2 mm");
  CHECK(refusal_of("{corridor: " + hairpin + ", half_width: 1.4 mm}").empty());
  check_refused("{corridor: [[0 mm, 0 mm], [20 mm, 0 mm], [20 mm, 9 mm], [10 mm, -9 mm]], half_width: 1 mm}",
                "it touches itself");
  CHECK(refusal_of("{corridor: [[0 mm, 0 mm], [20 mm, 0 mm], [1 mm, 6 mm]], half_width: 1 mm}").empty());
  CHECK(refusal_of("{corridor: [[0 mm, 0 mm], [20 mm, 0 mm], [9 mm, 20 mm]], half_width: 1 mm, closed: true}")
            .empty());
  check_refused("{spline: [[0 mm, 0 mm], [20 mm, 0 mm], [20 mm, 4 mm], [0 mm, 1 mm]], half_width: 1 mm}",
                "it touches itself");
}

TEST_CASE("What is no shape is told with what would be one") {
  check_refused("{radios: 3 mm}",
                "no shape is told by these keys; it is one of {center: [0 mm, 200 mm], radius: 8 mm}");
  check_refused("{center: [0 mm, 0 mm], radius: 3 mm, width: 2 mm}", "a shape with 'radius' has no 'width'");
  check_refused("{center: [0 mm, 0 mm], radius: 3 N}", "radius: '3 N' is no length; write it as 8 mm");
  check_refused("{center: [0 mm], radius: 3 mm}", "2 coordinates for a circle and 3 for a sphere");
  check_refused("{radius: 3 mm}", "'center' is missing");
  check_refused("{corridor: [[0 mm, 0 mm]], half_width: 1 mm}", "a list of 2 points or more");
  check_refused("{corridor: [[0 mm, 0 mm], [0 mm, 0 mm]], half_width: 1 mm}",
                "both (0, 0) mm; leave one out");
  check_refused("{left: -6 mm, right: 4 mm}", "'y' is missing");
  check_refused("{left: -6 mm, right: \"4 mm + z\", y: [0 mm, 1 mm]}", "it may use y");
  check_refused("{left: -6 mm, right: \"y > 0 ? 4 mm : 5 mm\", y: [-3 mm, 9 mm]}", "it jumps near ");
  check_refused("{left: -6 mm, right: \"sqrt(y)\", y: [-1 mm, 1 mm]}", "no finite value");
  check_refused("{union: []}", "a union is a list of shapes");
  check_refused("{union: [{center: [0 mm, 0 mm], radius: 1 mm}, {center: [0 mm, 0 mm, 5 mm], radius: 1 mm}]}",
                "both in the plane or both in space");
  check_refused("{union: [{center: [0, 0, 0], radius: 1}, {center: [0, 0, 1.5], radius: 1}]}",
                "shapes 1 and 2 of it overlap by 500 mm");
  check_refused("lens", "it must be a map");
}

TEST_CASE("A position of another number of coordinates is refused") {
  CHECK_THAT(error_of("step: 1 s\nstop: 1 s\nblocks:\n  map: {block: Region, shape: {center: [0, 0], radius: "
                      "1}, position: [0, 0, 0]}\n"),
             Contains("map.position") && Contains("3") && Contains("2"));
}

TEST_CASE("A shape takes parameters of its diagram") {
  const table::Table table = run_text(R"yaml(
step: 1 s
stop: 1 s
parameters:
  half:  {value: 8 mm}
  right: {value: (1 - ((y - 200 mm)/(20 mm))^2)*$half, doc: f}
blocks:
  map: {block: Region, shape: {left: "-($right)", right: $right, y: [180 mm, 220 mm]}, position: [20 mm, 200 mm]}
record: [map.distance]
)yaml");
  CHECK(column(table, "map.distance").front() == Approx(12e-3).margin(1e-9));
}
