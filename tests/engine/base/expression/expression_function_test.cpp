#include "engine/base/expression/expression_function.hpp"

#include <catch2/catch.hpp>

namespace stepwire::expression {

TEST_CASE("an expression is a function of those numbers that its variables are") {
  const double v[] = {1.0, 10.0, 100.0};
  const Function function = function_of(Expression("b - a + b"), {2, 0});
  const Function copy = function;
  CHECK(function(v) == 199.0);
  CHECK(copy(v) == 199.0);
  CHECK(function.source()->cpp() == "v[2] - v[0] + v[2]");
}

}  // namespace stepwire::expression
