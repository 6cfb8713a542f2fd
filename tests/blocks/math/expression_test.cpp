#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::string diagram(const std::string& keys) {
  return "step: 0.25 s\nstop: 1 s\nblocks:\n  t: {block: Clock}\n  y: {block: Expression, " + keys +
         "}\nrecord: [y]\n";
}

}  // namespace

TEST_CASE("a formula sees its inputs as u1, u2 and one alone as u") {
  const auto two = column(run_text(diagram("expression: 'sin(u1)*u2 - (u2 > 2 ? 1 : 0)', u: [t, 3]")), "y");
  const auto one = column(run_text(diagram("expression: u^2 + 1, u: [t]")), "y");
  for (std::size_t i = 0; i < two.size(); ++i) {
    const double t = 0.25 * static_cast<double>(i);
    REQUIRE(two[i] == Approx(3.0 * std::sin(t) - 1.0).margin(1e-15));
    REQUIRE(one[i] == Approx(t * t + 1.0));
  }
}

TEST_CASE("a formula goes element by element") {
  const Table run = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  a: {block: Constant, value: [1, 2, 3]}
  squares: {block: Expression, expression: u1 * u1 + u2, u: [a, 10]}
  total: {block: MatrixGain, gain: [[1, 1, 1]], u: squares}
record: [total]
)");
  REQUIRE(column(run, "total").back() == 44.0);
}

TEST_CASE("a formula that cannot be read is refused with the place in it") {
  REQUIRE_THAT(error_of(diagram("expression: u1 + * 2, u: [t]")),
               Catch::Contains("y.expression") && Catch::Contains("character 6"));
  REQUIRE_THAT(error_of(diagram("expression: u1 + u2, u: [t]")),
               Catch::Contains("y.expression") && Catch::Contains("character 6"));
  REQUIRE_THAT(error_of(diagram("expression: u1 + t, u: [t]")), Catch::Contains("Clock"));
}
