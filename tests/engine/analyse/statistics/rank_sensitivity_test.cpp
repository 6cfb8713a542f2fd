#include "engine/analyse/statistics/sensitivity_indices.hpp"

#include <Eigen/QR>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/base/math/normal_quantile.hpp"
#include "engine/base/sampling/design.hpp"

namespace stepwire::statistics {

namespace {

/// Makes a row for each sample: the first `shown` of its normal numbers, and the value of `of` for all of
/// them.
template <class Of>
std::vector<double> normal_rows(std::size_t samples, std::size_t parameters, std::size_t shown, Of of) {
  const auto points = sampling::points_of({sampling::Layout::sobol, samples, 3}, parameters);
  std::vector<double> rows;
  for (std::size_t i = 0; i < samples; ++i) {
    std::vector<double> x;
    for (const auto& numbers : points) x.push_back(normal_quantile(numbers[i]));
    rows.insert(rows.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(shown));
    rows.push_back(of(x));
  }
  return rows;
}

Eigen::VectorXd ranks_of(const std::vector<double>& rows, std::size_t width, std::size_t column) {
  std::vector<double> values;
  for (std::size_t at = column; at < rows.size(); at += width) values.push_back(rows[at]);
  const std::vector<double> all = ranks(values);
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd left_by(const Eigen::MatrixXd& others, const Eigen::VectorXd& of) {
  return of - others * others.colPivHouseholderQr().solve(of);
}

}  // namespace

TEST_CASE("the rank correlation of normal numbers is 6/pi asin(r/2)") {  // Kruskal 1958
  const auto rows = normal_rows(4096, 2, 2, [](const auto& x) { return 3.0 * x[0] - x[1]; });
  const RankSensitivity found = rank_sensitivity(rows, 2, {});
  CHECK(found.samples == 4096);
  const double of[] = {3.0 / std::sqrt(10.0), -1.0 / std::sqrt(10.0)};
  for (std::size_t i = 0; i < 2; ++i) {
    const double exact = 6.0 / std::numbers::pi * std::asin(0.5 * of[i]);
    CHECK(found.rank[i].value == Approx(exact).margin(0.005));
    CHECK(found.rank[i].interval.low < exact);
    CHECK(found.rank[i].interval.high > exact);
  }
}

TEST_CASE("a partial rank correlation is that of what the other ranks leave of both") {
  const auto rows =
      normal_rows(64, 4, 3, [](const auto& x) { return std::exp(2.0 * x[0]) - x[1] + x[0] * x[2] + x[3]; });
  const RankSensitivity found = rank_sensitivity(rows, 3, {});
  for (std::size_t i = 0; i < 3; ++i) {
    Eigen::MatrixXd others = Eigen::MatrixXd::Ones(64, 3);
    for (std::size_t k = 0, c = 1; k < 3; ++k)
      if (k != i) others.col(static_cast<Eigen::Index>(c++)) = ranks_of(rows, 4, k);
    const Eigen::VectorXd x = left_by(others, ranks_of(rows, 4, i)),
                          y = left_by(others, ranks_of(rows, 4, 3));
    CHECK(found.partial[i].value == Approx(x.dot(y) / x.norm() / y.norm()).epsilon(1e-9));
  }
}

TEST_CASE("an outcome that only goes up or down has the rank correlation 1 or -1, whatever its form") {
  const auto rows = normal_rows(100, 1, 1, [](const auto& x) { return -std::exp(9.0 * x[0]); });
  const RankSensitivity found = rank_sensitivity(rows, 1, {});
  CHECK(found.rank[0].value == Approx(-1.0));
  CHECK(found.partial[0].interval.high == Approx(-1.0));
}

TEST_CASE("what is not finite does not count, and what does not vary has no correlation") {
  const double infinite = std::numeric_limits<double>::infinity();
  const RankSensitivity found = rank_sensitivity(
      std::vector{1.0, 5.0, 1.0, 2.0, 5.0, 2.0, 3.0, 5.0, 3.0, 6.0, 5.0, 6.0, 4.0, 5.0, infinite}, 2, {});
  CHECK(found.samples == 4);
  CHECK(found.rank[0].value == Approx(1.0));
  CHECK(std::isnan(found.rank[1].value));
  CHECK(std::isnan(found.partial[0].value));
  const RankSensitivity none = rank_sensitivity(std::vector{1.0, infinite, 2.0, infinite}, 1, {});
  CHECK(none.samples == 0);
  CHECK(std::isnan(none.rank[0].value));
  CHECK(std::isnan(none.partial[0].interval.low));
}

TEST_CASE("correlations that too few samples make 1 are missing") {
  // Two ranks correlate by 1 or -1, and three samples with two parameters leave the partial ones no freedom.
  const auto rows = [](std::size_t samples) {
    return normal_rows(samples, 2, 2, [](const auto& x) { return 3.0 * x[0] - x[1]; });
  };
  for (const std::size_t samples : {2, 3})
    CHECK(std::isnan(rank_sensitivity(rows(samples), 2, {}).rank[0].value));
  CHECK(std::isfinite(rank_sensitivity(rows(4), 2, {}).rank[0].value));
  CHECK(std::isnan(rank_sensitivity(rows(4), 2, {}).partial[0].value));
  CHECK(std::isfinite(rank_sensitivity(rows(8), 2, {}).partial[0].value));
}

}  // namespace stepwire::statistics
