#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("division gives the quotient and its unit") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  speed: {block: Divide, numerator: 3 m, denominator: 1500 ms}
  check: {block: Sum, signs: "+-", u: [speed, 500 mm/s]}
record: [check]
)");
  REQUIRE(column(run, "check").back() == Approx(1.5));
}

TEST_CASE("division by zero ends the run and names the block") {
  REQUIRE_THAT(error_of(R"(
step: 0.5 s
stop: 2 s
blocks:
  t: {block: Ramp, initial: -1}
  y: {block: Divide, numerator: 1, denominator: t}
record: [y]
)"),
               Catch::Contains("y") && Catch::Contains("1"));
}
