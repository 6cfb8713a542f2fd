#include <catch2/catch.hpp>

#include "engine/base/math/instant.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a step jumps at the tick of its time and not one later") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1 s
blocks:
  y: {block: Step, time: 0.3 s, before: -1, after: 2}
record: [y]
)");
  REQUIRE(column(run, "y") == std::vector<double>{-1, -1, -1, 2, 2, 2, 2, 2, 2, 2, 2});
}

TEST_CASE("no tick of a run is late for an instant written in decimals") {
  // k times 0.3 and the decimal number 3 k / 10 differ in the last bit for many k.
  int early = 0;
  for (int k = 1; k < 100'000; ++k) {
    const double tick = k * 0.3, written = 3 * k / 10.0;
    early += tick < written;
    REQUIRE(reached(tick, written));
    REQUIRE_FALSE(reached((k - 1) * 0.3, written));
  }
  REQUIRE(early > 0);
}
