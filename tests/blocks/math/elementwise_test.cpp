// Abs, Sign, Sqrt, Trig, Atan2, MinMax: functions of each element.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Returns the output of a block with these keys for u = `slope` times -2, -1.5, ..., 2.
std::vector<double> map(const std::string& keys, const std::string& slope = "1") {
  return column(run_text("step: 0.5 s\nstop: 4 s\nblocks:\n  u: {block: Ramp, initial: " +
                         std::to_string(-2.0 * std::stod(slope)) + ", slope: " + slope + "}\n  y: {" + keys +
                         "}\nrecord: [y]\n"),
                "y");
}

}  // namespace

TEST_CASE("abs and sign take a number apart") {
  REQUIRE(map("block: Abs, u: u") == std::vector<double>{2, 1.5, 1, 0.5, 0, 0.5, 1, 1.5, 2});
  REQUIRE(map("block: Sign, u: u") == std::vector<double>{-1, -1, -1, -1, 0, 1, 1, 1, 1});
}

TEST_CASE("a signed root keeps the sign of its argument") {
  const auto y = map("block: Sqrt, signed: true, u: u", "8");
  REQUIRE(y.front() == -4.0);
  REQUIRE(y[4] == 0.0);
  REQUIRE(y.back() == 4.0);
}

TEST_CASE("the root of a negative number ends the run") {
  REQUIRE_THAT(error_of("step: 1 s\nstop: 1 s\nblocks:\n  y: {block: Sqrt, u: -1}\nrecord: [y]\n"),
               Catch::Contains("y"));
}

TEST_CASE("the root of an area is a length") {
  REQUIRE_THAT(error_of(R"(
step: 1 s
stop: 1 s
blocks:
  side: {block: Sqrt, u: 4 mm^2}
  wrong: {block: Sum, u: [side, 1 s]}
record: [wrong]
)"),
               Catch::Contains("wrong.u"));
}

TEST_CASE("trigonometric blocks are the functions of their names") {
  const std::vector<std::pair<std::string, double (*)(double)>> functions = {
      {"sin", fn::sin},   {"cos", fn::cos},   {"tan", fn::tan},   {"atan", fn::atan}, {"sinh", fn::sinh},
      {"cosh", fn::cosh}, {"tanh", fn::tanh}, {"asin", fn::asin}, {"acos", fn::acos}};
  for (const auto& [name, function] : functions) {
    const auto y = map("block: Trig, function: " + name + ", u: u", "0.5");
    for (std::size_t i = 0; i < y.size(); ++i)
      REQUIRE(y[i] == function(-1.0 + 0.25 * static_cast<double>(i)));
  }
}

TEST_CASE("atan2 finds the quadrant") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  second: {block: Atan2, opposite: 1 mm, adjacent: -1 mm}
  third: {block: Atan2, opposite: -1, adjacent: -1}
record: [second, third]
)");
  REQUIRE(column(run, "second").back() == Approx(0.75 * M_PI));
  REQUIRE(column(run, "third").back() == Approx(-0.75 * M_PI));
}

TEST_CASE("the least and the greatest of signals") {
  REQUIRE(map("block: MinMax, function: max, u: [u, 0.5, -1]") ==
          std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 1, 1.5, 2});
  REQUIRE(map("block: MinMax, u: [u, 0.5]") ==
          std::vector<double>{-2, -1.5, -1, -0.5, 0, 0.5, 0.5, 0.5, 0.5});
}
