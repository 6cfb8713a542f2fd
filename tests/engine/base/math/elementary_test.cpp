#include "engine/base/math/elementary.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

// SLEEF's form for one number, whose bits all others have.
extern "C" {
double Sleef_cinz_sind1_u10purec(double);
double Sleef_cinz_expd1_u10purec(double);
double Sleef_cinz_powd1_u10purec(double, double);
}

namespace stepwire {

namespace {

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

/// Numbers of both signs with sizes from 1e-12 to 1e2.
std::vector<double> numbers() {
  std::vector<double> all;
  for (int i = 0; i < 4000; ++i) {
    const double size = std::pow(10.0, -12.0 + 14.0 * i / 4000.0);
    all.push_back(i % 2 ? size : -size);
  }
  return all;
}

/// Distance of a double to a more precise number, in units of its last digit.
double units(double value, long double exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) /
                             static_cast<long double>(unit));
}

double worst(OfOne function, long double (*exact)(long double), double least, double most) {
  double worst = 0.0;
  for (const double x : numbers())
    if (x >= least && x <= most) worst = std::max(worst, units(function(x), exact(x)));
  return worst;
}

double worst(OfTwo function, long double (*exact)(long double, long double), bool positive) {
  double worst = 0.0;
  const std::vector<double> all = numbers();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double x = positive ? std::abs(all[i]) : all[i], y = all[(i * 37) % all.size()];
    const long double value = exact(x, y);
    if (std::abs(value) > 1e-300L && std::abs(value) < 1e300L)
      worst = std::max(worst, units(function(x, y), value));
  }
  return worst;
}

bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("elementary functions are within an ulp of those of long double") {
  CHECK(worst(fn::sin, std::sin, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::cos, std::cos, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::tan, std::tan, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::asin, std::asin, -1.0, 1.0) <= 1.0);
  CHECK(worst(fn::acos, std::acos, -1.0, 1.0) <= 1.0);
  CHECK(worst(fn::atan, std::atan, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::sinh, std::sinh, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::cosh, std::cosh, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::tanh, std::tanh, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::exp, std::exp, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::expm1, std::expm1, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::log, std::log, 0.0, infinite) <= 1.0);
  CHECK(worst(fn::log1p, std::log1p, -1.0, infinite) <= 1.0);
  CHECK(worst(fn::log2, std::log2, 0.0, infinite) <= 1.0);
  CHECK(worst(fn::log10, std::log10, 0.0, infinite) <= 1.0);
  CHECK(worst(fn::cbrt, std::cbrt, -infinite, infinite) <= 1.0);
  CHECK(worst(fn::erfc, std::erfc, -infinite, 25.0) <= 1.5);
  CHECK(worst(fn::atan2, std::atan2, false) <= 1.0);
  CHECK(worst(fn::pow, std::pow, true) <= 1.0);
  CHECK(worst(static_cast<OfTwo>(fn::hypot), std::hypot, false) <= 0.501);
}

TEST_CASE("elementary functions of arguments at their ends are those of IEEE 754") {
  for (OfOne odd : {OfOne(fn::sin), OfOne(fn::tan), OfOne(fn::asin), OfOne(fn::atan), OfOne(fn::sinh),
                    OfOne(fn::tanh), OfOne(fn::expm1), OfOne(fn::log1p), OfOne(fn::cbrt)}) {
    CHECK(same(odd(0.0), 0.0));
    CHECK(same(odd(-0.0), -0.0));
    CHECK(std::isnan(odd(std::nan(""))));
  }
  CHECK(std::isnan(fn::sin(infinite)));
  CHECK(std::isnan(fn::log(-1.0)));
  CHECK(std::isnan(fn::asin(1.5)));
  CHECK(fn::log(0.0) == -infinite);
  CHECK(fn::exp(-infinite) == 0.0);
  CHECK(fn::exp(710.0) == infinite);
  CHECK(fn::hypot(infinite, std::nan("")) == infinite);
  CHECK(fn::pow(0.0, -1.0) == infinite);
  CHECK(fn::pow(-8.0, 3.0) == -512.0);
  CHECK(std::isnan(fn::pow(-8.0, 0.5)));
  CHECK(fn::pow(std::nan(""), 0.0) == 1.0);
  CHECK(same(fn::atan2(-0.0, -1.0), -std::atan2(0.0, -1.0)));
  CHECK(fn::sin(1e22) == Approx(-0.8522008497671888).epsilon(1e-15));
  CHECK(fn::hypot(2.0, 3.0, 6.0) == 7.0);
}

TEST_CASE("powers of whole numbers, squares, and roots and logarithms of powers are exact") {
  for (int base = -50; base <= 50; ++base) {
    double power = 1.0;
    for (int exponent = 0; std::abs(power) < 9e15 && exponent < 10; ++exponent, power *= base) {
      INFO(base << "^" << exponent);
      CHECK(fn::pow(base, exponent) == power);
    }
  }
  for (const double x : numbers()) CHECK(fn::pow(x, 2.0) == x * x);
  for (int n = 1; n < 300; ++n) {
    CHECK(fn::cbrt(1.0 * n * n * n) == n);
    CHECK(fn::log2(std::ldexp(1.0, n)) == n);
  }
}

TEST_CASE("the form for two numbers has the bits of the form for one") {
  for (const double x : numbers()) {
    CHECK(same(fn::sin(x), Sleef_cinz_sind1_u10purec(x)));
    CHECK(same(fn::exp(x), Sleef_cinz_expd1_u10purec(x)));
    CHECK(same(fn::pow(std::abs(x), 1.3), Sleef_cinz_powd1_u10purec(std::abs(x), 1.3)));
  }
}

TEST_CASE("a selection calls the C library up to the end of its scope, on its own thread") {
  const auto of_sleef = [] {
    return std::ranges::any_of(numbers(), [](double x) { return !same(fn::exp(x), std::exp(x)); }) &&
           std::ranges::any_of(numbers(), [](double x) { return !same(fn::pow(1.7, x), std::pow(1.7, x)); });
  };
  const auto of_libm = [] {
    return std::ranges::all_of(numbers(), [](double x) {
      return same(fn::exp(x), std::exp(x)) && same(fn::pow(1.7, x), std::pow(1.7, x)) &&
             same(fn::hypot(x, 0.3), std::hypot(x, 0.3)) &&
             same(fn::hypot(x, 0.3, 7.0), std::hypot(x, 0.3, 7.0));
    });
  };
  REQUIRE(of_sleef());
  {
    const fn::Selection libm(true);
    CHECK(of_libm());
    bool on_other_thread = false;
    std::thread([&] { on_other_thread = of_sleef(); }).join();
    CHECK(on_other_thread);
    {
      const fn::Selection portable(false);
      CHECK(of_sleef());
    }
    CHECK(of_libm());
  }
  CHECK(of_sleef());
}

#ifdef __x86_64__
TEST_CASE("the other half of a register has no effect on the function of a number") {
  using Pair = double __attribute__((vector_size(16)));
  const auto any = reinterpret_cast<void (*)()>(fn::sleef::sin);
  const auto of_pair = reinterpret_cast<Pair (*)(Pair)>(any);
  for (const double other : {1e300, infinite, std::nan(""), 5e-324})
    for (const double x : {0.3, 14.9, 1e10})
      CHECK(same(of_pair(Pair{x, other})[0], Sleef_cinz_sind1_u10purec(x)));
}
#endif

}  // namespace stepwire
