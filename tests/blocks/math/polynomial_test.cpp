#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::vector<double> polynomial(const std::string& keys) {
  return column(
      run_text("step: 1 s\nstop: 4 s\nblocks:\n  t: {block: Ramp}\n  y: {block: Polynomial, u: t, " + keys +
               "}\nrecord: [y]\n"),
      "y");
}

std::string refused(const std::string& keys) {
  return error_of("step: 1 s\nstop: 4 s\nblocks:\n  y: {block: Polynomial, u: 1, " + keys +
                  "}\nrecord: [y]\n");
}

}  // namespace

TEST_CASE("coefficients stand with the highest power first") {
  REQUIRE(polynomial("coefficients: [1, -4, 0, 2]") == std::vector<double>{2, -1, -6, -7, 2});
  REQUIRE(polynomial("coefficients: [7]") == std::vector<double>(5, 7.0));
}

TEST_CASE("outside of its range a polynomial is held at the range's ends") {
  REQUIRE(polynomial("coefficients: [1, 0, 0], hold: [1, 2.5]") == std::vector<double>{1, 1, 4, 6.25, 6.25});
}

TEST_CASE("a range that is none is refused") {
  REQUIRE_THAT(refused("hold: [2, 1]"), Catch::Contains("y.hold"));
  REQUIRE_THAT(refused("hold: [2, 3, 4]"), Catch::Contains("y.hold"));
}
