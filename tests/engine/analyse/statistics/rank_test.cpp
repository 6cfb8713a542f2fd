#include "engine/analyse/statistics/descriptive.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire::statistics {

TEST_CASE("equal values share the mean of their ranks") {
  CHECK(ranks({10.0, 30.0, 20.0, 20.0}) == std::vector<double>{1.0, 4.0, 2.5, 2.5});
}

TEST_CASE("the rank correlation of IQ and hours of television is -29/165") {
  // The example of the article "Spearman's rank correlation coefficient" in Wikipedia: sum of squared
  // differences 194.
  const std::vector<double> iq{106, 100, 86, 101, 99, 103, 97, 113, 112, 110};
  const std::vector<double> hours{7, 27, 2, 50, 28, 29, 20, 12, 6, 17};
  CHECK(rank_correlation(iq, hours) == Approx(-29.0 / 165.0).margin(1e-15));
}

TEST_CASE("any growing relation has the rank correlation 1 and any falling one -1") {
  std::vector<double> x, growing, falling;
  for (int i = 0; i < 50; ++i) {
    x.push_back(i);
    growing.push_back(std::exp(0.1 * i));
    falling.push_back(-i * i * i);
  }
  CHECK(rank_correlation(x, growing) == Approx(1.0));
  CHECK(rank_correlation(x, falling) == Approx(-1.0));
}

TEST_CASE("ties are counted as the correlation of shared ranks") {
  // Ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: covariance 4.5, variances 4.5 and 5.
  CHECK(rank_correlation({1, 2, 2, 3}, {1, 2, 3, 4}) == Approx(4.5 / std::sqrt(4.5 * 5.0)));
}

TEST_CASE("what does not vary, is too short or is no number has no rank correlation") {
  CHECK(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3})));
  CHECK(std::isnan(rank_correlation({1}, {1})));
  CHECK(std::isnan(rank_correlation({1, NAN, 2}, {1, 2, 3})));
}

}  // namespace stepwire::statistics
