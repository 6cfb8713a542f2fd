#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a gain multiplies, by one number or by one for each element") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  u: {block: Constant, value: [3, 4]}
  one: {block: Gain, gain: 10, u: 2.5}
  both: {block: Gain, gain: 2, u: u}
  each: {block: Gain, gain: [-1, 0], u: u}
  both_length: {block: Norm, u: both}
  each_length: {block: Norm, u: each}
record: [one, both_length, each_length]
)");
  REQUIRE(column(run, "one").back() == 25.0);
  REQUIRE(column(run, "both_length").back() == 10.0);
  REQUIRE(column(run, "each_length").back() == 3.0);
}

TEST_CASE("the unit of a gain turns one unit into another") {
  const std::string blocks = R"(
step: 1 s
stop: 1 s
blocks:
  depth: {block: Constant, value: 5 mm}
  drive: {block: Gain, gain: 0.07 A/mm, u: depth}
  limit: {block: Sum, u: [drive, UNIT]}
record: [limit]
)";
  const auto with = [&](const std::string& unit) {
    return std::string(blocks).replace(blocks.find("UNIT"), 4, unit);
  };
  REQUIRE(column(run_text(with("1 A")), "limit").back() == Approx(1.35));
  REQUIRE_THAT(error_of(with("1 N")), Catch::Contains("limit.u"));
}
