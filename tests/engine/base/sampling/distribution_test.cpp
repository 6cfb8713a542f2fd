#include "engine/base/sampling/distribution.hpp"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/math/normal_quantile.hpp"

namespace stepwire::sampling {

using Kind = Distribution::Kind;

namespace {

const std::vector<double> shares{1e-9, 1e-3, 0.02, 0.25, 0.3, 0.5, 0.7, 0.9, 0.999, 1.0 - 1e-9};

/// Moments of a distribution by the midpoint rule over its quantiles.
struct Moments {
  double mean = 0.0, deviation = 0.0;
  explicit Moments(const Distribution& distribution) {
    constexpr int n = 200'000;
    double squares = 0.0;
    for (int i = 0; i < n; ++i) {
      const double value = distribution.quantile((i + 0.5) / n);
      mean += value / n;
      squares += value * value / n;
    }
    deviation = std::sqrt(squares - mean * mean);
  }
};

}  // namespace

TEST_CASE("quantiles of distributions are those of Boost.Math") {
  const Distribution normal{Kind::normal, {3.0, 0.5}}, lognormal{Kind::lognormal, {2.0, 0.2}},
      triangular{Kind::triangular, {1.0, 2.0, 4.0}};
  for (const double share : shares) {
    CHECK(normal.quantile(share) == Approx(quantile(boost::math::normal(3.0, 0.5), share)).margin(1e-13));
    const boost::math::lognormal of(std::log(2.0), std::sqrt(std::log(1.04)));
    CHECK(lognormal.quantile(share) == Approx(quantile(of, share)).epsilon(1e-12));
    CHECK(triangular.quantile(share) ==
          Approx(quantile(boost::math::triangular(1.0, 2.0, 4.0), share)).epsilon(1e-12));
  }
}

TEST_CASE("distributions have the moments of their closed forms") {
  const Moments uniform(Distribution{Kind::uniform, {100.0, 300.0}});
  CHECK(uniform.mean == Approx(200.0));
  CHECK(uniform.deviation == Approx(200.0 / std::sqrt(12.0)));
  const Moments normal(Distribution{Kind::normal, {-1.0, 2.0}});
  CHECK(normal.mean == Approx(-1.0));
  CHECK(normal.deviation == Approx(2.0).epsilon(1e-4));
  const Moments lognormal(Distribution{Kind::lognormal, {2.0, 0.2}});
  CHECK(lognormal.mean == Approx(2.0 * std::sqrt(1.04)).epsilon(1e-5));
  CHECK(lognormal.deviation / lognormal.mean == Approx(0.2).epsilon(1e-4));
  const Moments triangular(Distribution{Kind::triangular, {1.0, 2.0, 4.0}});
  CHECK(triangular.mean == Approx(7.0 / 3.0));
  CHECK(triangular.deviation == Approx(std::sqrt((1.0 + 4.0 + 16.0 - 2.0 - 4.0 - 8.0) / 18.0)));
}

TEST_CASE("words come as often as their weights say") {
  const Distribution words{Kind::words, {}, {1.0, 3.0, 4.0}};
  std::vector<int> count(3);
  for (int i = 0; i < 800; ++i) ++count[static_cast<std::size_t>(words.quantile((i + 0.5) / 800))];
  CHECK(count == std::vector<int>{100, 300, 400});
}

TEST_CASE("own elementary functions agree with those of the library") {
  for (double x = -700.0; x < 700.0; x += 0.37) CHECK(portable_exp(x) == Approx(std::exp(x)).epsilon(4e-16));
  CHECK(portable_exp(0.0) == 1.0);
  for (double x = -8.9; x < 9.0; x += 0.01)
    CHECK(std::abs(normal_probability(x) - 0.5 * std::erfc(-x / std::sqrt(2.0))) < 2e-15);
}

}  // namespace stepwire::sampling
