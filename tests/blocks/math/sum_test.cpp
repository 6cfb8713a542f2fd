#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

double sum(const std::string& keys) {
  return column(run_text("step: 1 s\nstop: 1 s\nblocks:\n  y: {block: Sum, " + keys + "}\nrecord: [y]\n"),
                "y")
      .back();
}

std::string refused(const std::string& keys) {
  return error_of("step: 1 s\nstop: 1 s\nblocks:\n  y: {block: Sum, " + keys + "}\nrecord: [y]\n");
}

}  // namespace

TEST_CASE("a sum adds what has a plus and subtracts what has a minus") {
  REQUIRE(sum("u: [1, 2, 4]") == 7.0);
  REQUIRE(sum("signs: '+-', u: [1, 2]") == -1.0);
  REQUIRE(sum("signs: '-+-', u: [1, 2, 4]") == -3.0);
  REQUIRE(sum("signs: '-', u: [3]") == -3.0);
}

TEST_CASE("a sum of vectors goes element by element and takes single numbers for every element") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [1, 2, 3]}
  y: {block: Sum, signs: "+-", u: [a, 10]}
  split: {block: Demux, sizes: [1, 1, 1], u: y}
record: [split.y1, split.y2, split.y3]
)");
  REQUIRE(column(run, "split.y1").back() == -9.0);
  REQUIRE(column(run, "split.y2").back() == -8.0);
  REQUIRE(column(run, "split.y3").back() == -7.0);
}

TEST_CASE("signs that are not one for each input are refused") {
  REQUIRE_THAT(refused("signs: '+-', u: [1, 2, 3]"),
               Catch::Contains("y.signs") && Catch::Contains("2 signs for 3 inputs"));
  REQUIRE_THAT(refused("signs: '+*', u: [1, 2]"), Catch::Contains("y.signs") && Catch::Contains("+ and -"));
}
