#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a constant has its value at every step") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1 s
blocks:
  force: {block: Constant, value: 5 mN}
record: [force]
)");
  REQUIRE(column(run, "force") == std::vector<double>(11, 5e-3));
}

TEST_CASE("a constant list is a vector") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  vector: {block: Constant, value: [3, 4]}
  length: {block: Norm, u: vector}
record: [length]
)");
  REQUIRE(column(run, "length") == std::vector<double>{5.0, 5.0});
}
