#include "engine/identify/affine_numbers.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace stepwire;

namespace {

using Numbers = std::vector<double>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// 2 a + b, a constant, no number, and 10 b, from a = 1, b = 3.
AffineNumbers some() {
  return {{1.0, 3.0},
          {5.0, 7.0, no_number, 30.0},
          {5.0, 7.0, no_number, 30.0},
          {{0.5, {6.0, 7.0, no_number, 30.0}}, {-1.0, {4.0, 7.0, no_number, 20.0}}}};
}

}  // namespace

TEST_CASE("numbers follow the parameters in straight lines, and what stands still stays to the bit") {
  const Numbers there = some().at({2.0, 5.0});
  CHECK(there[0] == 9.0);
  CHECK(there[1] == 7.0);
  CHECK(std::isnan(there[2]));
  CHECK(there[3] == 50.0);
}

TEST_CASE("agreement is that of all numbers, but for rounding") {
  CHECK(some().agrees({2.0, 5.0}, {9.0 * (1.0 + 1e-14), 7.0, no_number, 50.0}));
  CHECK_FALSE(some().agrees({2.0, 5.0}, {9.001, 7.0, no_number, 50.0}));
  CHECK_FALSE(some().agrees({2.0, 5.0}, {9.0, 7.0, 0.0, 50.0}));
  CHECK_FALSE(some().agrees({2.0, 5.0}, {9.0, 7.0, no_number}));
}
