#include "engine/analyse/statistics/contrasts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

/// Returns Helmert contrasts: orthonormal columns that sum to zero.
Eigen::MatrixXd contrasts(Eigen::Index levels) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(levels, levels - 1);
  for (Eigen::Index k = 0; k + 1 < levels; ++k) {
    const auto count = static_cast<double>(k + 1);
    result.col(k).head(k + 1).setConstant(1.0);
    result(k + 1, k) = -count;
    result.col(k) /= std::sqrt(count * (count + 1.0));
  }
  return result;
}

Eigen::MatrixXd kronecker(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd result(a.rows() * b.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      result.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return result;
}

}  // namespace

Eigen::MatrixXd cell_means(const Observations& observations, std::vector<std::string> factors,
                           const std::string& subject) {
  factors.insert(factors.begin(), subject);
  const auto all = cells(observations, factors);
  const std::size_t subjects = observations.factor(subject).levels.size(), columns = all.size() / subjects;
  Eigen::MatrixXd means(static_cast<Eigen::Index>(subjects), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& values = all[i].values;
    if (values.empty())
      throw StatisticsError(
          fmt::format("the design is not complete: there is no value for {}; repeated measures need one of "
                      "every subject in every cell",
                      cell_name(observations, factors, all[i])));
    means(static_cast<Eigen::Index>(i / columns), static_cast<Eigen::Index>(i % columns)) =
        moments_of(values).mean;
  }
  return means;
}

Eigen::MatrixXd contrasts_of(const std::vector<std::string>& term, const Observations& observations,
                             const std::vector<std::string>& factors) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Ones(1, 1);
  for (const std::string& name : factors) {
    const auto levels = static_cast<Eigen::Index>(observations.factor(name).levels.size());
    const bool varies = std::find(term.begin(), term.end(), name) != term.end();
    const Eigen::MatrixXd mean =
        Eigen::MatrixXd::Constant(levels, 1, 1.0 / std::sqrt(static_cast<double>(levels)));
    result = kronecker(result, varies ? contrasts(levels) : mean);
  }
  return result;
}

}  // namespace stepwire::statistics
