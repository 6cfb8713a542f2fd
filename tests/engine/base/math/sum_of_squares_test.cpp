#include "engine/base/math/sum_of_squares.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace stepwire {

namespace {

double length(const std::vector<double>& vector) {
  return length_of(vector.size(), [&](std::size_t i) { return vector[i]; });
}

}  // namespace

TEST_CASE("the length of a vector is right at every size that a double can have") {
  for (const double unit : {1.0, 1e-200, 1e200, 0x1p-1070, 0x1p1020, 1e-160, 1e160, 0x1p-450, 0x1p500}) {
    INFO(unit);
    CHECK(length({3.0 * unit, 4.0 * unit}) == Approx(5.0 * unit).epsilon(1e-15).margin(0x1p-1074));
    CHECK(length({2.0 * unit, -3.0 * unit, 6.0 * unit}) ==
          Approx(7.0 * unit).epsilon(1e-15).margin(0x1p-1074));
    CHECK(length({unit}) == Approx(unit).epsilon(1e-15));
  }
  CHECK(length({0x1p-1074}) == 0x1p-1074);
  CHECK(length({1e200, 1e-200, 1.0}) == 1e200);
  CHECK(length({1e-200, 0.0}) == 1e-200);
  CHECK(length({0.0, -0.0}) == 0.0);
  CHECK(length({}) == 0.0);
  CHECK(length({1e308, 1e308}) == Approx(std::sqrt(2.0) * 1e308));
}

TEST_CASE("the length of a vector is infinite or no number where the vector or the length is") {
  CHECK(std::isinf(length({INFINITY, 1.0})));
  CHECK(std::isinf(length({-INFINITY, 1e-300})));
  CHECK(std::isinf(length({1.7e308, 1.7e308})));
  CHECK(std::isnan(length({NAN, 1.0})));
  CHECK(std::isnan(length({NAN, 1e-300})));
}

TEST_CASE("ordinary numbers have the bits of the plain root of the plain sum") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-130.0, 130.0), mantissa(-1.0, 1.0);
  for (int i = 0; i < 10'000; ++i) {
    const double size = std::pow(10.0, exponent(random)), x = size * mantissa(random),
                 y = size * mantissa(random);
    if (length({x, y}) != std::sqrt(x * x + y * y)) FAIL(x << " " << y);
  }
}

TEST_CASE("a scaled sum has the squares of numbers that are scaled") {
  for (const double unit : {1.0, 1e-200, 1e200}) {
    SumOfSquares squares;
    squares.add(3.0 * unit);
    squares.add(4.0 * unit, 1.0 * unit, 2.0);  // twice both squares
    CHECK(squares.scaled() == Approx(43.0 * (unit * squares.scale()) * (unit * squares.scale())));
    CHECK(squares.root(43.0) == Approx(unit));
  }
}

}  // namespace stepwire
