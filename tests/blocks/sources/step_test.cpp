#include <catch2/catch.hpp>

#include "blocks/sources/instant.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a step jumps at the tick of its time and not one later") {
  const Table run = run_text(R"(
step: 0.1 s
stop: 1 s
blocks:
  y: {block: Step, time: 0.3 s, before: -1, after: 2}
record: [y]
)");
  REQUIRE(column(run, "y") == std::vector<double>{-1, -1, -1, 2, 2, 2, 2, 2, 2, 2, 2});
}

TEST_CASE("no tick of a run is late for an instant written in decimals") {
  // 0.001 k and the decimal number k/1000 differ in the last bit for many k, in either direction.
  int differ = 0;
  for (int k = 1; k < 100'000; ++k) {
    const double tick = k * 0.001, written = k / 1000.0;
    differ += tick < written;
    REQUIRE(reached(tick, written));
    REQUIRE_FALSE(reached((k - 1) * 0.001, written));
  }
  REQUIRE(differ > 0);
}
