// Norm, Dot, Cross: functions of whole vectors.
#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("norms of a vector") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [3, -4, 12]}
  length: {block: Norm, u: a}
  sum: {block: Norm, kind: sum, u: a}
  max: {block: Norm, kind: max, u: a}
record: [length, sum, max]
)");
  REQUIRE(column(run, "length").back() == 13.0);
  REQUIRE(column(run, "sum").back() == 19.0);
  REQUIRE(column(run, "max").back() == 12.0);
}

TEST_CASE("the vector product stands upright on both factors and has their area") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [1, 2, 3]}
  b: {block: Constant, value: [-2, 0.5, 4]}
  c: {block: Cross, u: [a, b]}
  ac: {block: Dot, u: [a, c]}
  bc: {block: Dot, u: [b, c]}
  cc: {block: Dot, u: [c, c]}
  aa: {block: Dot, u: [a, a]}
  bb: {block: Dot, u: [b, b]}
  ab: {block: Dot, u: [a, b]}
  split: {block: Demux, sizes: [1, 1, 1], u: c}
record: [ac, bc, cc, aa, bb, ab, split.y1, split.y2, split.y3]
)");
  const auto last = [&](const char* name) { return column(run, name).back(); };
  REQUIRE(last("ac") == 0.0);
  REQUIRE(last("bc") == 0.0);
  REQUIRE(last("cc") == last("aa") * last("bb") - last("ab") * last("ab"));  // Lagrange's identity
  REQUIRE(last("split.y1") == 6.5);                                          // 2*4 - 3*0.5: the sign by hand
}

TEST_CASE("products of vectors take two") {
  REQUIRE_THAT(error_of("step: 1 s\nstop: 1 s\nblocks:\n  y: {block: Dot, u: [1, 2, 3]}\nrecord: [y]\n"),
               Catch::Contains("y.u") && Catch::Contains("takes two"));
}
