#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a ramp stays at its initial value and grows by its slope from its start on") {
  const table::Table run = run_text(R"(
step: 0.5 s
stop: 3 s
blocks:
  y: {block: Ramp, slope: -2, start: 1 s, initial: 10}
record: [y]
)");
  REQUIRE(column(run, "y") == std::vector<double>{10, 10, 10, 9, 8, 7, 6});
}
