#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a matrix gain multiplies a vector from the left") {
  // [1 2 3; 4 5 6] [1; 10; 100] = [321; 654]
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  u: {block: Constant, value: [1, 10, 100]}
  y: {block: MatrixGain, gain: [[1, 2, 3], [4, 5, 6]], u: u}
  split: {block: Demux, sizes: [1, 1], u: y}
record: [split.y1, split.y2]
)");
  REQUIRE(column(run, "split.y1").back() == 321.0);
  REQUIRE(column(run, "split.y2").back() == 654.0);
}

TEST_CASE("a matrix that does not fit its vector is refused") {
  REQUIRE_THAT(error_of(R"(
step: 1 s
stop: 1 s
blocks:
  u: {block: Constant, value: [1, 10]}
  y: {block: MatrixGain, gain: [[1, 2, 3], [4, 5, 6]], u: u}
record: [y]
)"),
               Catch::Contains("y.u") && Catch::Contains("3"));
}
