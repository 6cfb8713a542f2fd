// Blocks of matrices, against products and inverses by hand.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string head = "step: 1 s\nstop: 1 s\nblocks:\n";

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

}  // namespace

TEST_CASE("two matrices are multiplied, and a vector is one of one column") {
  // [1 2; 3 4] [5 6; 7 8] = [19 22; 43 50], and that times [1; 10] = [239; 543]
  const table::Table run = run_text(head + R"(
  A: {block: Constant, value: [[1, 2], [3, 4]]}
  AB: {block: MatrixMultiply, a: A, b: [[5, 6], [7, 8]]}
  v: {block: MatrixMultiply, a: AB, b: [1, 10]}
record: [AB, v]
)");
  CHECK(last(run, "AB.1.1") == 19.0);
  CHECK(last(run, "AB.1.2") == 22.0);
  CHECK(last(run, "AB.2.1") == 43.0);
  CHECK(last(run, "AB.2.2") == 50.0);
  CHECK(last(run, "v.1") == 239.0);
  CHECK(last(run, "v.2") == 543.0);
}

TEST_CASE("a block that works on every element keeps rows and columns") {
  const table::Table run = run_text(head + R"(
  A: {block: Constant, value: [[1, 2, 3], [4, 5, 6]]}
  B: {block: Gain, u: A, gain: 10}
  C: {block: Sum, u: [A, B]}
  D: {block: UnitDelay, u: C, initial: [[7, 7, 7], [7, 7, 9]]}
record: [C, D]
)");
  CHECK(last(run, "C.2.3") == 66.0);
  CHECK(column(run, "D.2.3").front() == 9.0);
  CHECK(last(run, "D.1.2") == 22.0);
}

TEST_CASE("rows become columns") {
  const table::Table run = run_text(head + R"(
  A: {block: Transpose, u: [[1, 2, 3], [4, 5, 6]]}
record: [A]
)");
  CHECK(last(run, "A.3.1") == 3.0);
  CHECK(last(run, "A.1.2") == 4.0);
}

TEST_CASE("a matrix times its inverse is one, also where the first pivot is zero") {
  const table::Table run = run_text(head + R"(
  A: {block: Constant, value: [[0, 2, 1], [3, 0, 5], [1, 4, 0]]}
  B: {block: Inverse, u: A}
  one: {block: MatrixMultiply, a: A, b: B}
record: [one, B]
)");
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 3; ++column) {
      CAPTURE(row, column);
      CHECK(last(run, "one." + std::to_string(row) + "." + std::to_string(column)) ==
            Approx(row == column ? 1.0 : 0.0).margin(1e-15));
    }
  CHECK(last(run, "B.1.1") == Approx(-20.0 / 22.0));  // (0*0 - 5*4)/det, det = 22
}

TEST_CASE("a matrix of many rows is inverted, too") {
  // The inverse of the bidiagonal matrix with 2 and 1 below it has (-1/2)^(i-j) / 2 in row i and column j.
  const int rows = 70;
  std::string written;
  for (int i = 0; i < rows; ++i) {
    written += i ? ", [" : "[";
    for (int j = 0; j < rows; ++j)
      written += std::string(j ? ", " : "") + (i == j ? "2" : i == j + 1 ? "1" : "0");
    written += "]";
  }
  const table::Table run = run_text(head + "  A: {block: Inverse, u: [" + written +
                                    "]}\n  x: {block: Mux, u: [A.70.70, A.70.67, A.1.70]}\nrecord: [x]\n");
  CHECK(last(run, "x.1") == 0.5);
  CHECK(last(run, "x.2") == -0.0625);
  CHECK(last(run, "x.3") == 0.0);
}

TEST_CASE("a singular matrix has no inverse, which ends the run") {
  CHECK_THAT(error_of(head + R"(
  A: {block: Inverse, u: [[1, 2], [2, 4]]}
record: [A]
)"),
             Catch::Contains("A: the matrix is singular and has no inverse") && Catch::Contains("(at 0 s)") &&
                 Catch::Contains("'enable'"));
}

TEST_CASE("a matrix that becomes singular ends the run by its own words, and not as what is not finite") {
  // [[t, 1], [1, t]] is singular at 1 s; the state behind it would be the first that is not finite.
  const auto rig = [](const std::string& condition) {
    return R"(step: 1 ms
stop: 2 s
solver: rk4
blocks:
  t: {block: Clock}
  one: {block: Stack, u: [t, 1]}
  two: {block: Stack, u: [1, t]}
  A: {block: Concatenate, u: [one, two]}
  x: {block: Integrator, u: B.1.1}
  B: {block: Inverse, u: A)" +
           condition + "}\nrecord: [x]\n";
  };
  CHECK_THAT(error_of(rig("")), Catch::Contains("B: the matrix is singular") && Catch::Contains("(at 1 s)"));
  CHECK(error_of(rig(", enable: abs(t - 1) > 1.5e-3")).empty());
}

TEST_CASE("a singular matrix is found where rounding leaves a pivot, and none where units differ alone") {
  const auto refused = [](const std::string& matrix) {
    return !error_of(head + "  A: {block: Inverse, u: " + matrix + "}\nrecord: [A]\n").empty();
  };
  // Of rank 1, and of rank 2: the numbers of its last row are 0.1 and 0.7 times those above.
  CHECK(refused("[[0.1, 0.7], [0.3, 2.1]]"));
  CHECK(refused("[[0.1, 0.2, 0.3], [1.3, -1.7, 0.9], [0.92, -1.17, 0.66]]"));
  CHECK_FALSE(refused("[[1, 0], [0, 1e-20]]"));
  CHECK_FALSE(refused("[[1e9, 1], [1, 1e-8]]"));
  CHECK_FALSE(refused("[[1, 1], [1, 1.00000001]]"));
}

TEST_CASE("matrices stand side by side and one below the other") {
  const table::Table run = run_text(head + R"(
  A: {block: Constant, value: [[1, 2], [3, 4]]}
  wide: {block: Concatenate, u: [A, [5, 6]]}
  high: {block: Stack, u: [A, [[7, 8]]]}
record: [wide, high]
)");
  CHECK(last(run, "wide.1.3") == 5.0);
  CHECK(last(run, "wide.2.2") == 4.0);
  CHECK(last(run, "high.3.1") == 7.0);
  CHECK(last(run, "high.2.2") == 4.0);
}

TEST_CASE("what stands beside other matrices may be as wide as those that it is made of") {
  const table::Table run = run_text(head + R"(
  late: {block: UnitDelay, u: A, initial: 0}
  back: {block: Transpose, u: tall}
  tall: {block: Stack, u: [both, both]}
  both: {block: Concatenate, u: [late, row, A]}
  row:  {block: Reshape, u: pair, rows: 2, columns: 1}
  pair: {block: Mux, u: [A.1.1, A.2.2]}
  A:    {block: Constant, value: [[1, 2], [3, 4]]}
record: [back]
)");
  const double expected[4][5] = {{1, 2, 1, 1, 2}, {3, 4, 4, 3, 4}, {1, 2, 1, 1, 2}, {3, 4, 4, 3, 4}};
  for (int row = 1; row <= 4; ++row)
    for (int column = 1; column <= 5; ++column) {
      CAPTURE(row, column);
      CHECK(last(run, "back." + std::to_string(column) + "." + std::to_string(row)) ==
            expected[row - 1][column - 1]);
    }
}

TEST_CASE("sizes that nothing tells are found alike in each order of the blocks") {
  std::vector<std::string> blocks{"high: {block: Stack, u: [wave]}",
                                  "tall: {block: Stack, u: [0.5, wave, wave]}", "wave: {block: Sine}",
                                  "wide: {block: Concatenate, u: [wave, high, wave]}"};
  do {
    INFO(fmt::format("{}", fmt::join(blocks, "\n")));
    const table::Table run =
        run_text(fmt::format("{}  {}\nrecord: [tall, wide]\n", head, fmt::join(blocks, "\n  ")));
    CHECK(last(run, "tall.1") == 0.5);
    CHECK(last(run, "tall.3") == std::sin(2.0 * std::numbers::pi));
    CHECK(last(run, "wide.1.3") == last(run, "tall.3"));
  } while (std::next_permutation(blocks.begin(), blocks.end()));
}

TEST_CASE("what has no whole columns, other units or no end stands beside no matrix") {
  const std::string A = "  A: {block: Constant, value: {value: [[1, 2], [3, 4]], unit: N}}\n";
  const auto error = [&](const std::string& blocks) { return error_of(head + A + blocks + "record: [B]\n"); };
  CHECK_THAT(error("  B: {block: Concatenate, u: [A, 5 N]}\n"),
             Catch::Contains("this has 1 element, which are no whole columns of 2"));
  CHECK_THAT(error("  B: {block: Stack, u: [A, [5 N, 6 N, 7 N]]}\n"), Catch::Contains("B.u"));
  CHECK_THAT(error("  B: {block: Concatenate, u: [A, [5 m, 6 m]]}\n"), Catch::Contains("is in m"));
  CHECK_THAT(error("  B: {block: Concatenate, u: [late, A]}\n  late: {block: UnitDelay, u: B}\n"),
             Catch::Contains("columns together"));
}

TEST_CASE("a number alone is no matrix of equal numbers") {
  const std::string A = "  A: {block: Constant, value: [[1, 2], [3, 4]]}\n";
  CHECK_THAT(error_of(head + A + "  B: {block: MatrixMultiply, a: A, b: 3}\nrecord: [B]\n"),
             Catch::Contains("B.b") && Catch::Contains("2 x"));
  CHECK_THAT(error_of(head + A + "  B: {block: MatrixMultiply, a: 3, b: A}\nrecord: [B]\n"),
             Catch::Contains("B"));
  const table::Table run = run_text(head + "  B: {block: Inverse, u: 4}\nrecord: [B]\n");
  CHECK(last(run, "B") == 0.25);
}

TEST_CASE("rows and columns that a matrix has not are refused with what it has") {
  const std::string A = "  A: {block: Constant, value: [[1, 2, 3], [3, 4, 5]]}\n";
  CHECK_THAT(error_of(head + A + "  B: {block: Slice, u: A, rows: [3], columns: [1]}\nrecord: [B]\n"),
             Catch::Contains("fed 2 rows; it needs at least 3"));
  CHECK_THAT(error_of(head + A + "  B: {block: Slice, u: A, rows: [1], columns: [1, 4]}\nrecord: [B]\n"),
             Catch::Contains("fed 3 columns; it needs at least 4"));
}

TEST_CASE("a vector becomes a matrix column by column, and rows and columns are chosen") {
  const table::Table run = run_text(head + R"(
  R: {block: Reshape, u: [1, 2, 3, 4, 5, 6], rows: 2, columns: 3}
  S: {block: Slice, u: R, rows: [2], columns: [3, 1]}
record: [R, S]
)");
  CHECK(last(run, "R.2.1") == 2.0);
  CHECK(last(run, "R.1.3") == 5.0);
  CHECK(last(run, "S.1.1") == 6.0);
  CHECK(last(run, "S.1.2") == 2.0);
}

TEST_CASE("matrices that do not fit are refused with their shapes") {
  CHECK_THAT(error_of(head + R"(
  A: {block: Constant, value: [[1, 2, 3], [4, 5, 6]]}
  B: {block: MatrixMultiply, a: A, b: A}
record: [B]
)"),
             Catch::Contains("B.b") && Catch::Contains("2 x 3"));
}
