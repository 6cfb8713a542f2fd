#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a clock gives the time, and holds it between its ticks") {
  const table::Table run = run_text(R"(
step: 0.25 s
stop: 1 s
blocks:
  now: {block: Clock}
  slow: {block: Clock, every: 0.5 s}
record: [now, slow]
)");
  REQUIRE(column(run, "now") == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
  REQUIRE(column(run, "now") == column(run, "time"));
  REQUIRE(column(run, "slow") == std::vector<double>{0.0, 0.0, 0.5, 0.5, 1.0});
}
