#include "engine/analyse/statistics/rank_sensitivity.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rank.hpp"

namespace stepwire::statistics {

namespace {

/// Returns the ranks of each column, centred and of length 1; nan for a constant column.
Eigen::MatrixXd unit_ranks(const Samples& samples, const Choice& choice) {
  Eigen::MatrixXd columns(choice.size(), samples.width);
  std::vector<double> values(choice.size());
  for (std::size_t c = 0; c < samples.width; ++c) {
    for (std::size_t i = 0; i < choice.size(); ++i) values[i] = samples[choice[i]][c];
    const std::vector<double> ranked = ranks(values);
    auto column = columns.col(static_cast<Eigen::Index>(c));
    column = Eigen::Map<const Eigen::VectorXd>(ranked.data(), static_cast<Eigen::Index>(ranked.size()));
    column.array() -= column.mean();
    const double length = column.norm();
    column /= length > 0.0 ? length : no_number;
  }
  return columns;
}

/// Returns the partial correlation of each parameter with the outcome (the last column), given the others.
Eigen::VectorXd partial_correlations(const Eigen::MatrixXd& correlations) {
  constexpr double singular = 1e-10;
  const Eigen::Index last = correlations.rows() - 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlations.topLeftCorner(last, last));
  if (!(solver.eigenvalues()[0] > singular)) return Eigen::VectorXd::Constant(last, no_number);
  const Eigen::VectorXd together = correlations.col(last).head(last);
  const Eigen::MatrixXd inverse = correlations.topLeftCorner(last, last).inverse();
  const Eigen::VectorXd weights = inverse * together;
  const double unexplained = std::max(0.0, 1.0 - together.dot(weights));
  // From the block inverse P of the whole correlation matrix: -P_iy / sqrt(P_ii P_yy).
  return weights.array() / (inverse.diagonal().array() * unexplained + weights.array().square()).sqrt();
}

/// Returns the rank correlations of all parameters, then the partial ones.
std::vector<double> correlations_of(const Samples& samples, const Choice& choice) {
  const auto parameters = static_cast<Eigen::Index>(samples.width) - 1;
  if (choice.size() < fewest_rows(0)) return std::vector<double>(2 * (samples.width - 1), no_number);
  const bool enough = choice.size() >= fewest_rows(samples.width - 2);
  const Eigen::MatrixXd columns = unit_ranks(samples, choice);
  const Eigen::MatrixXd correlations = columns.transpose() * columns;
  Eigen::VectorXd all(2 * parameters);
  all << correlations.col(parameters).head(parameters),
      enough && correlations.allFinite() ? partial_correlations(correlations)
                                         : Eigen::VectorXd::Constant(parameters, no_number);
  return {all.data(), all.data() + all.size()};
}

}  // namespace

RankSensitivity rank_sensitivity(std::span<const double> rows, std::size_t parameters,
                                 const Bootstrap& bootstrap) {
  const Samples samples(rows, parameters + 1);
  const auto all =
      estimate(samples, bootstrap, [&](const Choice& choice) { return correlations_of(samples, choice); });
  return {part_of(all, 0, parameters), part_of(all, 1, parameters), samples.count};
}

}  // namespace stepwire::statistics
