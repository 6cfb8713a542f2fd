#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <string>
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

namespace {

/// Returns a held formula's value at x, with its modes from another place.
double held_at(const Expression& formula, double x, double place) {
  const Held held = held_of(formula, 4);
  std::vector<double> values;
  for (const std::string& name : held.formula.variables()) {
    const auto mode = std::ranges::find(held.names, name) - held.names.begin();
    const bool is_mode = mode < std::ssize(held.names);
    values.push_back(is_mode ? held.modes[static_cast<std::size_t>(mode)](std::vector{place}) : x);
  }
  return held.formula(values);
}

constexpr const char* jumping[] = {"x*sign(x)",
                                   "x + floor(3*x)",
                                   "ceil(2*x) + x",
                                   "x - round(4*x)",
                                   "mod(x, 0.37)",
                                   "mod(x, -0.37) + x > 0.2 ? 3*x : x",
                                   "x > 0.2 && x < 0.6 ? x : -x",
                                   "x*(!(x <= 0.3) || x == 0.1)",
                                   "(x > 0 ? x > 0.5 : x < -0.5) ? x : 2",
                                   "(x ? floor(x) : 2) + sin(x)",
                                   "abs(x)*sign(x - 0.3)",
                                   "max(x, sign(x))"};

}  // namespace

TEST_CASE("where the margin of a step has changed its sign, the value has changed, to the last bit") {
  for (const char* text : {"floor(x)", "ceil(x)", "round(x)", "mod(x, 0.5)", "mod(x, -1.5)"}) {
    const Expression formula(text);
    const Expression margin = branches_of(formula).margins.front();
    const auto sign = [&](double x) { return margin(std::vector{x}); };
    for (double jump = -3.0; jump <= 3.0; jump += 0.5)
      for (const double side : {-1.0, 1.0}) {
        INFO(text << " at " << jump << " from " << side);
        const double before = jump - 0.2 * side;
        for (double x : {std::nextafter(jump, 9.0 * -side), jump, std::nextafter(jump, 9.0 * side)}) {
          const double change = formula(std::vector{x}) - formula(std::vector{before});
          if (sign(x) * sign(before) < 0.0) CHECK(std::abs(change) > 0.25);
        }
        if (const double far = jump + 0.2 * side; sign(far) * sign(before) > 0.0)
          CHECK(std::abs(formula(std::vector{far}) - formula(std::vector{before})) < 0.45);
      }
  }
}

TEST_CASE("a held formula has the bits of the formula with the modes of the same place") {
  for (const char* text : jumping) {
    const Expression formula(text);
    CHECK_FALSE(held_of(formula, 4).modes.empty());
    for (double x = -1.0; x < 1.0; x += 0.0101) {
      INFO(text << " at " << x);
      CHECK(held_at(formula, x, x) == formula(std::vector{x}));
    }
  }
}

TEST_CASE("a held formula goes on smoothly beyond its jumps") {
  for (const char* text : jumping) {
    const Expression formula(text);
    for (const double place : {-0.83, -0.17, 0.13, 0.52, 0.77}) {
      const double h = 0.2;
      const auto at = [&](double x) { return held_at(formula, x, place); };
      if (std::string(text).find("max") != std::string::npos ||
          std::string(text).find("abs") != std::string::npos)
        continue;  // bends remain
      INFO(text << " from " << place);
      const double change = at(place + 2.0 * h) - 3.0 * at(place + h) + 3.0 * at(place) - at(place - h);
      CHECK(std::abs(change) < 0.02);  // of a jump: more than 0.1
    }
  }
}

TEST_CASE("bends are not held, and a formula without jumps is the same") {
  for (const char* text : {"abs(x)", "min(x, 0.2)", "sin(x)"}) {
    const Held held = held_of(Expression(text), 4);
    CHECK(held.modes.empty());
    CHECK(held.formula(std::vector{0.7}) == Expression(text)(std::vector{0.7}));
  }
}

TEST_CASE("modes of a formula have names that its variables have not") {
  const Held held = held_of(Expression("mode0 > 1 ? mode0 : mode1"), 4);
  REQUIRE(held.names.size() == 1);
  CHECK(held.names.front() == "mode_0");
}

}  // namespace stepwire::expression
