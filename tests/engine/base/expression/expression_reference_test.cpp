#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/elementary.hpp"

namespace {

/// A random formula: its text with as few parentheses as precedence allows, and its value by plain C++.
struct Formula {
  std::string text;
  double value;
  int binding;  // of its outermost operator; an operand that binds weaker than its place
                // requires gets parentheses
};

constexpr int atom = 9;
constexpr std::array<double, 3> xyz{0.75, -2.5, 3.0};

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  Formula make(int depth) {
    const unsigned choice = depth == 0 ? 0 : 1 + random_() % 12;
    switch (choice) {
      case 0:
        return leaf();
      case 1:
        return conditional(depth);
      case 2:
        return prefix("-", make(depth - 1), [](double a) { return -a; });
      case 3:
        return prefix("!", make(depth - 1), [](double a) { return a == 0.0 ? 1.0 : 0.0; });
      case 4:
        return power(depth);
      case 5:
        return binary("||", 1, depth, [](double a, double b) { return a || b ? 1.0 : 0.0; });
      case 6:
        return binary("&&", 2, depth, [](double a, double b) { return a && b ? 1.0 : 0.0; });
      case 7:
        return binary("<", 4, depth, [](double a, double b) { return a < b ? 1.0 : 0.0; });
      case 8:
        return binary(">=", 4, depth, [](double a, double b) { return a >= b ? 1.0 : 0.0; });
      case 9:
        return binary("+", 5, depth, [](double a, double b) { return a + b; });
      case 10:
        return binary("-", 5, depth, [](double a, double b) { return a - b; });
      case 11:
        return binary("*", 6, depth, [](double a, double b) { return a * b; });
      default:
        return binary("/", 6, depth, [](double a, double b) { return a / b; });
    }
  }

 private:
  Formula leaf() {
    const unsigned i = random_() % 5;
    if (i < 3) return {std::string(1, "xyz"[i]), xyz[i], atom};
    return i == 3 ? Formula{"0.5", 0.5, atom} : Formula{"2", 2.0, atom};
  }

  static std::string in(const Formula& formula, int least) {
    return formula.binding < least ? "(" + formula.text + ")" : formula.text;
  }

  Formula conditional(int depth) {
    const Formula c = make(depth - 1), a = make(depth - 1), b = make(depth - 1);
    return {in(c, 1) + " ? " + a.text + " : " + b.text, c.value != 0.0 ? a.value : b.value, 0};
  }

  template <class Value>
  static Formula prefix(const std::string& sign, const Formula& a, Value value) {
    return {sign + in(a, 7), value(a.value), 7};
  }

  Formula power(int depth) {
    const Formula a = make(depth - 1), b = make(depth - 1);
    return {in(a, 9) + "^" + in(b, 7), stepwire::fn::pow(a.value, b.value), 8};
  }

  template <class Value>
  Formula binary(const std::string& sign, int binding, int depth, Value value) {
    const Formula a = make(depth - 1), b = make(depth - 1);
    const int first = binding == 4 ? 5 : binding;  // comparisons cannot be chained
    return {in(a, first) + " " + sign + " " + in(b, binding + 1), value(a.value, b.value), binding};
  }

  std::mt19937 random_;
};

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

TEST_CASE("random formulas have the value that C++ gives them, to the last bit") {
  Maker maker(11);
  for (int i = 0; i < 5000; ++i) {
    const Formula formula = maker.make(1 + i % 4);
    INFO(formula.text);
    const stepwire::expression::Expression expression(formula.text,
                                                      [](std::string_view name) { return name.size() == 1; });
    std::vector<double> values;
    for (const std::string& name : expression.variables())
      values.push_back(xyz[static_cast<std::size_t>(name[0] - 'x')]);
    REQUIRE(same(expression(values), formula.value));
  }
}
