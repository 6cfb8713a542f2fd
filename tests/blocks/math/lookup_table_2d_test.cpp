#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::string diagram_text(const std::string& keys) {
  return "step: 1 s\nstop: 5 s\nblocks:\n  r: {block: Ramp, initial: -1}\n  c: {block: Ramp, initial: 12, "
         "slope: -1}\n"
         "  y: {block: LookupTable2D, row: r, column: c, " +
         keys + "}\nrecord: [r, c, y]\n";
}

// The surface 1 + 2 r + 3 c + 4 r c, which bilinear pieces meet exactly.
const char* const surface = "rows: [0, 1, 4], columns: [8, 10], values: [[25, 31], [59, 73], [161, 199]]";

}  // namespace

TEST_CASE("a bilinear surface is met inside of its table, and beyond by linear extrapolation") {
  const table::Table run = run_text(diagram_text(std::string(surface) + ", extrapolation: linear"));
  const auto &r = column(run, "r"), &c = column(run, "c"), &y = column(run, "y");
  for (std::size_t i = 0; i < y.size(); ++i)
    REQUIRE(y[i] == Approx(1 + 2 * r[i] + 3 * c[i] + 4 * r[i] * c[i]));
}

TEST_CASE("a table holds its edges unless told otherwise") {
  const table::Table run = run_text(diagram_text(surface));
  REQUIRE(column(run, "y").front() == 31.0);  // row -1, column 12
  REQUIRE(column(run, "y").back() == 161.0);  // row 4, column 7
}

TEST_CASE("values that do not fill the grid are refused") {
  REQUIRE_THAT(error_of(diagram_text("rows: [0, 1, 2], columns: [0, 1], values: [[1, 2, 3], [4, 5, 6]]")),
               Catch::Contains("y.values") && Catch::Contains("must be 3 x 2"));
}
