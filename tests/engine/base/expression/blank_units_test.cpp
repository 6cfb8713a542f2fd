#include <catch2/catch.hpp>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

TEST_CASE("a blank multiplies units behind a number, as in a value") {
  CHECK(Expression("0.4 N s/m")({}) == 0.4);
  CHECK(Expression("2 * 3 mN m + 1")({}) == 2 * 3e-3 + 1);
  CHECK(Expression("0.4 N s/m * x", [](std::string_view name) { return name == "x"; })(std::vector{5.0}) ==
        2.0);
  CHECK(Expression("4 kN mm")({}) == Approx(4.0));
}

TEST_CASE("what is a name is no unit, and what is called is none") {
  const auto known = [](std::string_view name) { return name == "s"; };
  CHECK_THROWS_WITH(Expression("4 N s", known), "an operator is missing before 's'");
  CHECK_THROWS_WITH(Expression("4 N min(1, 2)"), "an operator is missing before 'min'");
}

}  // namespace stepwire::expression
