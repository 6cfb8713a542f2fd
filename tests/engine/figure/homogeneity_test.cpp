#include "engine/figure/homogeneity.hpp"

#include <catch2/catch.hpp>

using namespace stepwire;

namespace {

const Dimension metre{{1}}, second{{0, 0, 1}}, newton{{1, 1, -2}};

std::optional<Dimension> found(const std::string& text, const std::vector<Dimension>& dimensions) {
  return dimension_of(Expression(text), dimensions);
}

}  // namespace

TEST_CASE("the dimension of an expression follows from those of its variables") {
  CHECK(found("a", {newton}) == newton);
  CHECK(found("abs(a) + 3*b", {metre, metre}) == metre);
  CHECK(found("hypot(a, b)", {metre, metre}) == metre);
  CHECK(found("a*b", {newton, metre}) == newton * metre);
  CHECK(found("a/b", {metre, second}) == metre / second);
  CHECK(found("sqrt(a)", {metre}) == power(metre, 0.5));
  CHECK(found("a > b", {metre, metre}) == Dimension{});
  CHECK(found("a > 0 ? b : -b", {metre, newton}) == newton);
}

TEST_CASE("an expression that does not scale has no known dimension") {
  CHECK_FALSE(found("a + 1", {metre}));
  CHECK_FALSE(found("a + b", {metre, newton}));
  CHECK_FALSE(found("sin(a)", {metre}));
  CHECK_FALSE(found("min(a, 1)", {metre}));
  CHECK_FALSE(found("a - a", {metre}));
  CHECK_FALSE(found("2", {}));
}
