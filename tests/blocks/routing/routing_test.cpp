#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("what is joined and taken apart again is the same") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 2 s
blocks:
  t: {block: Ramp}
  pair: {block: Constant, value: [5, 7]}
  joined: {block: Mux, u: [t, pair, -1]}
  split: {block: Demux, sizes: [1, 2, 1], u: joined}
  seven: {block: Select, indices: [2], u: split.y2}
  turned: {block: Select, indices: [4, 1, 1], u: joined}
  sum: {block: MatrixGain, gain: [[1, 10, 100]], u: turned}
record: [split.y1, split.y3, seven, sum]
)");
  REQUIRE(column(run, "split.y1") == std::vector<double>{0, 1, 2});
  REQUIRE(column(run, "split.y3") == std::vector<double>{-1, -1, -1});
  REQUIRE(column(run, "seven") == std::vector<double>{7, 7, 7});
  REQUIRE(column(run, "sum") == std::vector<double>{-1, 109, 219});
}

TEST_CASE("elements that are not there are refused") {
  const auto refused = [](const std::string& block) {
    return error_of("step: 1 s\nstop: 2 s\nblocks:\n  u: {block: Constant, value: [1, 2]}\n  y: {" + block +
                    ", u: u}\n  end: {block: Terminator, u: y" + (block.find("Demux") == 7 ? ".y1" : "") +
                    "}\nrecord: [u]\n");
  };
  REQUIRE_THAT(refused("block: Select, indices: [3]"),
               Catch::Contains("y: is fed 2 elements; it needs at least 3"));
  REQUIRE_THAT(refused("block: Select, indices: [0]"), Catch::Contains("y.indices"));
  REQUIRE_THAT(refused("block: Select, indices: [1.5]"), Catch::Contains("y.indices"));
  REQUIRE_THAT(refused("block: Demux, sizes: [1, 2]"), Catch::Contains("y.u") && Catch::Contains("3"));
  REQUIRE_THAT(refused("block: Demux, sizes: [1, 0.5]"), Catch::Contains("y.sizes"));
}
