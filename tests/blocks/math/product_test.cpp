#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a product multiplies element by element") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [1, 2, -3]}
  y: {block: Product, u: [a, a, 2]}
  total: {block: MatrixGain, gain: [[1, 1, 1]], u: y}
  three: {block: Product, u: [2, 3, 7]}
record: [total, three]
)");
  REQUIRE(column(run, "total").back() == 28.0);
  REQUIRE(column(run, "three").back() == 42.0);
}

TEST_CASE("the unit of a product is that of its factors multiplied") {
  REQUIRE_THAT(error_of(R"(
step: 1 s
stop: 1 s
blocks:
  power: {block: Product, u: [2 N, 3 m/s]}
  wrong: {block: Sum, u: [power, 1 J]}
record: [wrong]
)"),
               Catch::Contains("wrong.u"));
}
