#include "engine/base/expression/margin.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace stepwire::expression {

TEST_CASE("the margin of a condition is above 0 where it holds and below where it does not") {
  for (const char* text : {"x < 1", "x > 0.3 && y < 0.2", "x >= 0.5 || y <= -0.5", "!(x > 0.4) && x + y > 0",
                           "x > y ? y < 0 : x > 0.1", "-x > 400 mm || !(x > y || y > 0.7)",
                           "max(x, y) > 0.35 && min(x, y) < 1e-3"}) {
    INFO(text);
    const Expression condition(text), margin = margin_of(condition);
    REQUIRE(margin.variables() == condition.variables());
    for (double x = -1.03; x < 1.0; x += 0.07)
      for (double y = -1.01; y < 1.0; y += 0.09) {
        std::vector<double> values{x, y};
        if (condition.variables().front() == "y") std::swap(values[0], values[1]);
        values.resize(condition.variables().size());
        CHECK((margin(values) > 0.0) == (condition(values) != 0.0));
      }
  }
}

TEST_CASE("the margin goes through 0 without a jump, so that a secant finds where") {
  const Expression margin = margin_of(Expression("x > 3 mm && x < 1"));
  const auto at = [&](double x) { return margin(std::vector{x}); };
  CHECK(at(0.004) == Approx(0.001));
  CHECK(at(0.0) == Approx(-0.003));
  CHECK(at(0.9) == Approx(0.1));
}

TEST_CASE("of what is no comparison the margin is the value") {
  CHECK(margin_of(Expression("2*x - 1"))(std::vector{0.7}) == Approx(0.4));
  CHECK(margin_of(Expression("e + pi", [](std::string_view name) { return name == "e"; }))(
            std::vector{1.0}) == Approx(1.0 + 3.14159265358979));
}

}  // namespace stepwire::expression
