#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("an assertion ends the run at the step at which it fails first") {
  const std::string error = error_of(R"(
step: 0.5 s
stop: 5 s
blocks:
  t: {block: Ramp}
  low: {block: Expression, expression: u < 2, u: [t]}
  below_two: {block: Assert, u: low}
record: [t]
)");
  REQUIRE_THAT(error, Catch::Contains("below_two") && Catch::Contains("at 2 s"));
}

TEST_CASE("an assertion that holds, and a terminator, change nothing") {
  const table::Table run = run_text(R"(
step: 0.5 s
stop: 1 s
blocks:
  t: {block: Ramp}
  fine: {block: Assert, u: 1}
  unused: {block: Terminator, u: t}
record: [t]
)");
  REQUIRE(column(run, "t") == std::vector<double>{0, 0.5, 1});
}
