#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "engine/base/expression/margin.hpp"

namespace stepwire::expression {

namespace {

std::vector<bool> signs(const Branches& branches, double x) {
  std::vector<bool> all;
  for (const Expression& margin : branches.margins) all.push_back(margin(std::vector{x}) > 0.0);
  return all;
}

}  // namespace

TEST_CASE("where a formula jumps or has a bend a margin has changed its sign") {
  for (const char* text : {"abs(x)", "sign(x - 0.3)", "floor(3*x)", "ceil(2*x) + x", "round(4*x)",
                           "mod(x, 0.37)", "min(x, 0.2)", "max(x, -x, 0.4)", "abs(x - 0.1) + abs(x + 0.6)",
                           "x*floor(2*x)", "min(max(x, -0.5), 0.5)", "x > 0.2 ? abs(x) : 7"}) {
    INFO(text);
    const Expression formula(text);
    const Branches branches = branches_of(formula);
    const auto at = [&](double x) { return formula(std::vector{x}); };
    const double part = 1e-5;
    std::size_t bends = 0;
    for (double x = -1.0 + 1e-7; x < 1.0; x += part) {
      if (std::abs(at(x + part) - 2.0 * at(x) + at(x - part)) < 0.1 * part) continue;
      ++bends;
      CHECK(signs(branches, x + part) != signs(branches, x - part));
    }
    CHECK(bends > 0);
  }
}

TEST_CASE("a formula of steps and conditions alone is steady, and one that varies in between is not") {
  for (const char* text :
       {"sign(x)", "floor(3*x) + 2*(x > 1)", "x > 0 ? 3 : sign(y)", "!(x > 2)", "mod(round(x), 3)"})
    CHECK(branches_of(Expression(text)).steady);
  for (const char* text : {"x", "abs(x)", "x*sign(y)", "x > 0 ? x : 1", "mod(x, 3)", "3 + 4"})
    CHECK_FALSE(branches_of(Expression(text)).steady);
}

TEST_CASE("numbers and functions of numbers have no margins") {
  for (const char* text : {"2*x + abs(3)", "x^2 + floor(2.5)", "sin(x) + min(3, 4)"})
    CHECK(branches_of(Expression(text)).margins.empty());
  CHECK(branches_of(Expression("mod(round(x), 3)")).margins.size() == 1);
  CHECK(branches_of(Expression("min(x, y, 3)")).margins.size() == 2);
}

TEST_CASE("margins of jumps come before those of bends") {
  const Branches branches = branches_of(Expression("abs(x - 1) + min(x, 2) + (x > 3 ? x : 0) + sign(x - 4)"));
  REQUIRE(branches.margins.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const double at[] = {3.0, 4.0, 1.0, 2.0};
    CHECK(branches.margins[i](std::vector{at[i]}) == Approx(0.0).margin(1e-12));
  }
}

}  // namespace stepwire::expression
