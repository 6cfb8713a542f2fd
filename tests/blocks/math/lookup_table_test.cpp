#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// The table's value for u = -1, 0, 1, 2, 3, 4.
std::string diagram_text(const std::string& keys) {
  return "step: 1 s\nstop: 5 s\nblocks:\n  u: {block: Ramp, initial: -1}\n  y: {block: LookupTable, u: u, " +
         keys + "}\nrecord: [y]\n";
}

}  // namespace

TEST_CASE("a table is straight between its points and follows its rule beyond them") {
  const std::string table = "points: [0, 1, 3], values: [0, 10, 0]";
  REQUIRE(column(run_text(diagram_text(table)), "y") == std::vector<double>{0, 0, 10, 5, 0, 0});
  REQUIRE(column(run_text(diagram_text(table + ", extrapolation: linear")), "y") ==
          std::vector<double>{-10, 0, 10, 5, 0, -5});
  REQUIRE_THAT(error_of(diagram_text(table + ", extrapolation: refuse")), Catch::Contains("y"));
}

TEST_CASE("points that do not increase, and values that are not as many, are refused") {
  REQUIRE_THAT(error_of(diagram_text("points: [0, 2, 2], values: [0, 1, 2]")),
               Catch::Contains("y.points") && Catch::Contains("element 3"));
  REQUIRE_THAT(error_of(diagram_text("points: [0, 2], values: [0, 1, 2]")), Catch::Contains("y.values"));
  REQUIRE_THAT(error_of(diagram_text("points: [0], values: [0]")), Catch::Contains("y.points"));
}

TEST_CASE("a table in units takes arguments in others of the same kind") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  y: {block: LookupTable, u: 5 mm, points: {value: [0, 1], unit: cm}, values: {value: [0, 8], unit: N}}
record: [y]
)");
  REQUIRE(column(run, "y").back() == Approx(4.0));
}
