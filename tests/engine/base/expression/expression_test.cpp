#include "engine/base/expression/expression.hpp"
#include "engine/base/math/elementary.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace stepwire::expression {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double value(const std::string& text, const std::vector<double>& values = {}) {
  INFO(text);
  const Expression expression(text);
  REQUIRE(expression.variables().size() == values.size());
  return expression(values);
}

std::string repeated(int count, const std::string& piece) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

double value_among(const std::set<std::string>& names, const std::string& text,
                   const std::vector<double>& values) {
  const Expression expression(text,
                              [&](std::string_view name) { return names.count(std::string(name)) > 0; });
  REQUIRE(expression.variables().size() == values.size());
  return expression(values);
}

}  // namespace

TEST_CASE("arithmetic binds as in mathematics") {
  CHECK(value("1 + 2 * 3") == 7.0);
  CHECK(value("(1 + 2) * 3") == 9.0);
  CHECK(value("8 / 4 / 2") == 1.0);
  CHECK(value("8 - 4 - 2") == 2.0);
  CHECK(value("2^3^2") == 512.0);
  CHECK(value("-2^2") == -4.0);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("2 - -3") == 5.0);
  CHECK(value("--3") == 3.0);
  CHECK(value("+3") == 3.0);
  CHECK(value("-3 * -2") == 6.0);
  CHECK(value("2/3") == 2.0 / 3.0);
  CHECK(value(".5e1 + 1E-1") == 5.1);
}

TEST_CASE("comparisons and logic give 1 or 0") {
  CHECK(value("1 < 2") == 1.0);
  CHECK(value("2 <= 1") == 0.0);
  CHECK(value("1 == 1 && 2 != 3") == 1.0);
  CHECK(value("1 > 2 || 3 >= 3") == 1.0);
  CHECK(value("1 || 0 && 0") == 1.0);
  CHECK(value("!0") == 1.0);
  CHECK(value("!3") == 0.0);
  CHECK(value("!!3") == 1.0);
  CHECK(value("!(1 > 2) && !0") == 1.0);
  CHECK(value("1<!0") == 0.0);
  CHECK(value("1!=!1") == 1.0);
  CHECK(value("2 && 3") == 1.0);
}

TEST_CASE("a condition chooses one of two values") {
  CHECK(value("1 > 2 ? 3 : 4") == 4.0);
  CHECK(value("x > 0 ? 1 : x < 0 ? -1 : 0", {-2.0}) == -1.0);
  CHECK(value("x > 0 ? 1 : x < 0 ? -1 : 0", {0.0}) == 0.0);
  CHECK(value("x > 0 ? x > 5 ? 2 : 1 : 0", {7.0}) == 2.0);
  CHECK(value("2 * (x ? 3 : 4) + 1", {1.0}) == 7.0);
  CHECK(value("max(x ? 3 : 4, 2)", {0.0}) == 4.0);
}

TEST_CASE("functions are those of elementary.hpp") {
  CHECK(value("sin(0.3)") == fn::sin(0.3));
  CHECK(value("cos(0.3) + tan(0.3)") == fn::cos(0.3) + fn::tan(0.3));
  CHECK(value("asin(0.3) + acos(0.3) + atan(0.3)") == fn::asin(0.3) + fn::acos(0.3) + fn::atan(0.3));
  CHECK(value("atan2(1, -1)") == fn::atan2(1.0, -1.0));
  CHECK(value("sinh(1) + cosh(1) + tanh(1)") == fn::sinh(1.0) + fn::cosh(1.0) + fn::tanh(1.0));
  CHECK(value("exp(1)") == fn::exp(1.0));
  CHECK(value("log(e)") == 1.0);
  CHECK(value("log2(8) + log10(1000)") == 6.0);
  CHECK(value("sqrt(16) + cbrt(27)") == 7.0);
  CHECK(value("abs(-3) + hypot(3, 4)") == 8.0);
  CHECK(value("sign(-2) + 10*sign(0) + 100*sign(5)") == 99.0);
  CHECK(value("floor(-1.5) + 10*ceil(1.2) + 100*round(2.5) + 1000*round(-2.5)") ==
        -2.0 + 20.0 + 300.0 - 3000.0);
  CHECK(value("min(3, 1, 2) + 10*max(1, 3) + 100*max(7, 2, 3)") == 731.0);
  CHECK(value("mod(7, 3) + 10*mod(-1, 3) + 100*mod(1, -3) + 1000*mod(6, 3)") == 1.0 + 20.0 - 200.0);
  CHECK(value("pi") == std::numbers::pi);
  CHECK(value("e") == std::numbers::e);
}

TEST_CASE("the longest and deepest texts have their values") {
  CHECK(value(repeated(2499, "x^") + "x", {1.0}) == 1.0);
  CHECK(value(repeated(2499, "1+") + "x", {1.0}) == 2500.0);
  CHECK(value("min(" + repeated(2497, "1,") + "x)", {-3.0}) == -3.0);
  CHECK(value(repeated(1249, "x?x:") + "x", {2.0}) == 2.0);
  CHECK(value(repeated(1249, "x?x:") + "x", {0.0}) == 0.0);
  CHECK(value(repeated(1200, "x?") + "7" + repeated(1200, ":0"), {1.0}) == 7.0);
  CHECK(value(repeated(199, "1-(") + "x" + repeated(199, ")"), {4.0}) == -3.0);
}

TEST_CASE("a number may carry a unit and is SI then") {
  CHECK(value("2*pi*3 kHz") == 2 * std::numbers::pi * 3000.0);
  CHECK(value("0.1 ms") == 1e-4);
  CHECK(value("5mm + 2 in") == 0.005 + 0.0508);
  CHECK(value("abs(limit) / 0.35 A", {-0.7}) == 2.0);
  CHECK(value("rig.x > -4 mm && rig.x < 5 mm", {0.0049}) == 1.0);
  CHECK(value("rig.x > -4 mm && rig.x < 5 mm", {-0.0041}) == 0.0);
  CHECK(value("90 deg") == std::numbers::pi / 2);
  CHECK(value("3 mm/s*2") == 0.006);
  CHECK(value("6 mm/2") == 0.003);
  CHECK(value("5 1/s") == 5.0);
  CHECK(value("6 1/min") == 0.1);
  CHECK(value("51/s", {17.0}) == 3.0);
  CHECK(value("5 % * 2") == 0.1);
  CHECK(value("x ? 1 mm : 2 mm", {0.0}) == 0.002);
  CHECK(value("3 m^2") == 3.0);
  CHECK(value("2 m - 1 m") == 1.0);
  CHECK(value("2 m-1") == 1.0);
  CHECK(value("(5 N.m)/(1 J/(kg.K))") == 5.0);
}

TEST_CASE("a variable may be named like a unit, a constant or a function") {
  CHECK(value("4 * N", {3.0}) == 12.0);
  CHECK(value("m * s + N", {2.0, 3.0, 4.0}) == 10.0);
  CHECK(value_among({"m"}, "4 mA/m", {2.0}) == 0.002);
  CHECK(value_among({}, "4 mA/m", {}) == 0.004);
  CHECK(value_among({"e", "pi"}, "e + pi", {2.0, 3.0}) == 5.0);
  CHECK(value_among({"max", "v0", "c0", "sum", "avg", "rint", "_pi"},
                    "max(max, 1) + v0 + c0 + sum + avg + rint + _pi",
                    {2.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0}) == 212.0);
}

TEST_CASE("names have dots and indices and are listed as they first appear") {
  const Expression expression("b.y[2] + a + b.y[2] * rig.arm.x1 - pi");
  CHECK(expression.variables() == std::vector<std::string>{"b.y[2]", "a", "rig.arm.x1"});
  CHECK(expression.text() == "b.y[2] + a + b.y[2] * rig.arm.x1 - pi");
}

TEST_CASE("division by zero and what has no value give inf and nan as IEEE says") {
  CHECK(value("1/x", {0.0}) == infinity);
  CHECK(value("-1/0") == -infinity);
  CHECK(std::isnan(value("x/x", {0.0})));
  CHECK(std::isnan(value("x - x", {infinity})));
  CHECK(std::isnan(value("sqrt(-1) + log(-1)")));
  CHECK(value("log(0)") == -infinity);
  CHECK(std::isnan(value("mod(1, 0)")));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(value("min(1, x)", {nan})));
  CHECK(std::isnan(value("max(x, 1)", {nan})));
  CHECK(std::isnan(value("sign(x)", {nan})));
  CHECK(value("x == x", {nan}) == 0.0);
}

TEST_CASE("numbers are read alike in every locale") {
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German));
  const double read = value("1.5 + 0.25 mm + 1000.125 + max(1.5,2.5)");
  std::locale::global(before);
  CHECK(read == 1.5 + 0.00025 + 1000.125 + 2.5);
}

TEST_CASE("one expression serves any number of threads, and copies are values") {
  const Expression original("a*a + b");
  std::vector<std::thread> threads;
  std::vector<int> good(4, 0);
  for (std::size_t t = 0; t < good.size(); ++t) {
    threads.emplace_back([&good, &original, t] {
      for (int i = 0; i < 1000; ++i)
        good[t] += original(std::vector<double>{double(i), double(t)}) == i * i + double(t);
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(good == std::vector<int>(4, 1000));
  Expression assigned("1");
  assigned = original;
  Expression moved(std::move(assigned));
  CHECK(moved(std::vector<double>{3.0, 1.0}) == 10.0);
  moved = Expression("a - 1");
  CHECK(moved(std::vector<double>{3.0}) == 2.0);
}

TEST_CASE("the variables of a text may be renamed, and nothing else of it changes") {
  const Expression expression("x > 5 mm && max(x, rig.v)*pi < 2 A/m ? x : rig.v");
  REQUIRE(expression.variables() == std::vector<std::string>{"x", "rig.v"});
  const std::string text = expression.renamed({"rig.cart.position", "m"});
  CHECK(text == "rig.cart.position > 5 mm && max(rig.cart.position, m)*pi < 2 A/m ? rig.cart.position : m");
  CHECK(Expression(text)(std::vector<double>{0.1, 0.3}) == expression(std::vector<double>{0.1, 0.3}));
}

}  // namespace stepwire::expression
