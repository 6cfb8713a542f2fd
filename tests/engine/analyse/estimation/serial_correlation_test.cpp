
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "engine/analyse/estimation/certainty.hpp"

namespace stepwire::estimation {

namespace {

/// r(k) = persistence r(k-1) + white noise of variance 1, settled.
Eigen::VectorXd autoregressive(double persistence, Eigen::Index rows, std::mt19937_64& random) {
  std::normal_distribution<double> white;
  Eigen::VectorXd r(rows);
  double last = white(random) / std::sqrt(1.0 - persistence * persistence);
  for (Eigen::Index k = 0; k < rows; ++k) r[k] = last = persistence * last + white(random);
  return r;
}

}  // namespace

TEST_CASE("White residuals are taken for independent") {
  std::mt19937_64 random(1);
  const SerialCorrelation serial = SerialCorrelation::of(autoregressive(0.0, 5000, random), {0, 2500});
  CHECK(serial.rows <= 2);
  CHECK(serial.inflation < 1.1);
}

TEST_CASE("Residuals that fade by 0.9 a row are worth (1 - 0.9)/(1 + 0.9) of their number") {
  std::mt19937_64 random(2);
  const SerialCorrelation serial = SerialCorrelation::of(autoregressive(0.9, 20000, random), {0, 10000});
  CHECK(serial.rows > 10);
  CHECK(serial.inflation == Approx(19.0).epsilon(0.15));
}

TEST_CASE("The covariance of a sum weighs lags by Bartlett, within each stretch alone") {
  SerialCorrelation serial;
  serial.rows = 1;  // windows of 4 rows: weights 1, 3/4, 1/2, 1/4
  Eigen::MatrixXd terms(5, 1);
  terms << 1.0, 2.0, -1.0, 4.0, 3.0;
  const double first = 1.0 + 4.0 + 1.0 + 2.0 * (0.75 * (2.0 - 2.0) + 0.5 * -1.0);
  const double second = 16.0 + 9.0 + 2.0 * 0.75 * 12.0;
  CHECK(serial.covariance_of_sum(terms, {0, 3})(0, 0) == Approx(first + second));
}

TEST_CASE("Intervals of a mean hold the truth as often as they say, although residuals last") {
  std::mt19937_64 random(3);
  constexpr Eigen::Index rows = 4000;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> ones =
      Eigen::MatrixXd::Ones(rows, 1);
  int held = 0;
  for (int k = 0; k < 400; ++k) {
    const Eigen::VectorXd noise = autoregressive(0.8, rows, random);
    const double mean = noise.mean();
    const Certainty certainty =
        certainty_of((noise.array() - mean).matrix(), ones, Eigen::VectorXd::Ones(1), rows - 1.0, {{0}});
    held += std::abs(mean) <= certainty.half_widths[0];
  }
  CHECK(held >= 0.90 * 400);
  CHECK(held <= 0.985 * 400);
}

}  // namespace stepwire::estimation
