#include <array>
#include <catch2/catch.hpp>

#include "engine/base/expression/expression.hpp"
#include "tests/support/allocations.hpp"

TEST_CASE("an evaluation allocates nothing, not even the first one or that of a copy") {
  const stepwire::expression::Expression expression(
      "x > -4 mm && !(y < 2) ? max(sin(x), hypot(x, y), 3) : mod(y, 2*pi) / 0 + min(x, y)^2");
  const stepwire::expression::Expression copy(expression);
  std::array<double, 2> values{0.001, 3.0};
  double sum = 0.0;
  const long before = stepwire::allocations();
  for (int i = 0; i < 100; ++i) {
    values[1] = i * 0.1;
    sum += expression(values) + copy(values);
  }
  const long after = stepwire::allocations();
  CHECK(after == before);
  CHECK(sum != 0.0);
}
