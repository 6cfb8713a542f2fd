#include "engine/base/sampling/design.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "engine/base/math/normal_quantile.hpp"
#include "engine/base/sampling/correlation.hpp"

namespace stepwire::sampling {

namespace {

/// The centred discrepancy of Hickernell (A generalized discrepancy and quadrature error bound, 1998),
/// squared.
double discrepancy(const Points& points) {
  const std::size_t n = points.front().size();
  double once = 0.0, twice = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double product = 1.0;
    for (const auto& x : points) {
      const double off = std::abs(x[i] - 0.5);
      product *= 1.0 + 0.5 * off - 0.5 * off * off;
    }
    once += product;
    for (std::size_t k = 0; k < n; ++k) {
      double pair = 1.0;
      for (const auto& x : points)
        pair *= 1.0 + 0.5 * (std::abs(x[i] - 0.5) + std::abs(x[k] - 0.5) - std::abs(x[i] - x[k]));
      twice += pair;
    }
  }
  const auto count = static_cast<double>(n);
  return std::pow(13.0 / 12.0, static_cast<double>(points.size())) - 2.0 * once / count +
         twice / (count * count);
}

/// True if each of n equal layers of [0, 1) contains one of the n numbers.
bool fills_layers(std::vector<double> numbers) {
  std::ranges::sort(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (static_cast<std::size_t>(numbers[i] * static_cast<double>(numbers.size())) != i) return false;
  return true;
}

}  // namespace

TEST_CASE("the first points of a design are those of a smaller one") {
  for (const Layout layout : {Layout::random, Layout::sobol}) {
    const Points few = points_of({layout, 37, 5}, 3), many = points_of({layout, 500, 5}, 4);
    for (std::size_t d = 0; d < few.size(); ++d)
      CHECK(std::equal(few[d].begin(), few[d].end(), many[d].begin()));
  }
}

TEST_CASE("seeds draw other points, and the same seed the same ones") {
  for (const Layout layout : {Layout::random, Layout::latin_hypercube, Layout::sobol}) {
    CHECK(points_of({layout, 64, 5}, 2) == points_of({layout, 64, 5}, 2));
    CHECK(points_of({layout, 64, 5}, 2) != points_of({layout, 64, 6}, 2));
  }
}

TEST_CASE("a Latin hypercube has one point in each layer of each dimension") {
  for (const std::size_t points : {1, 7, 100, 1000})
    for (const auto& numbers : points_of({Layout::latin_hypercube, points, 2}, 5))
      CHECK(fills_layers(numbers));
}

TEST_CASE("a power of two of Sobol points fills each layer, and elementary boxes of two dimensions") {
  const Points points = points_of({Layout::sobol, 1024, 9}, 12);
  for (const auto& numbers : points) CHECK(fills_layers(numbers));
  // The first two dimensions are a (0, m, 2)-net: each box of 2^-a x 2^-b with a + b = m holds one point.
  for (int a = 0; a <= 10; ++a) {
    std::set<std::pair<int, int>> boxes;
    for (std::size_t i = 0; i < 1024; ++i)
      boxes.emplace(static_cast<int>(std::ldexp(points[0][i], a)),
                    static_cast<int>(std::ldexp(points[1][i], 10 - a)));
    CHECK(boxes.size() == 1024);
  }
}

TEST_CASE("Sobol points have a lower discrepancy than random ones, and Latin hypercubes lie between") {
  for (const std::size_t dimensions : {2, 5}) {
    double random = 0.0, latin = 0.0, sobol = 0.0;
    for (const std::int64_t seed : {1, 2, 3}) {
      random += discrepancy(points_of({Layout::random, 256, seed}, dimensions));
      latin += discrepancy(points_of({Layout::latin_hypercube, 256, seed}, dimensions));
      sobol += discrepancy(points_of({Layout::sobol, 256, seed}, dimensions));
    }
    CHECK(sobol < 0.5 * latin);
    CHECK(latin < 0.5 * random);
  }
}

TEST_CASE("correlated points have the correlation of their normal scores, and stay even alone") {
  Eigen::Matrix3d wanted;
  wanted << 1.0, 0.7, 0.0, 0.7, 1.0, -0.4, 0.0, -0.4, 1.0;
  const auto factor = correlation_factor(wanted);
  REQUIRE(factor);
  Points points = points_of({Layout::sobol, 4096, 1}, 3);
  const std::vector<double> before = points[0];
  correlate(points, *factor);
  CHECK(points[0] == before);
  for (Eigen::Index a = 0; a < 3; ++a)
    for (Eigen::Index b = 0; b < 3; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 4096; ++i)
        sum += normal_quantile(points[static_cast<std::size_t>(a)][i]) *
               normal_quantile(points[static_cast<std::size_t>(b)][i]) / 4096;
      CHECK(sum == Approx(wanted(a, b)).margin(0.01));
    }
  for (auto numbers : points) {
    std::ranges::sort(numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      CHECK(std::abs(numbers[i] - (static_cast<double>(i) + 0.5) / 4096) < 0.02);
  }
}

TEST_CASE("a matrix that is not positive definite correlates nothing") {
  Eigen::Matrix3d wrong;
  wrong << 1.0, 0.9, -0.9, 0.9, 1.0, 0.9, -0.9, 0.9, 1.0;
  CHECK_FALSE(correlation_factor(wrong));
  CHECK_FALSE(correlation_factor(Eigen::Matrix2d::Ones()));
}

}  // namespace stepwire::sampling
