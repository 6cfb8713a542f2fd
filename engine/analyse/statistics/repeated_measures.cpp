#include "engine/analyse/statistics/repeated_measures.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire {
namespace {

constexpr double doubtful_epsilon = 0.75, significant = 0.05;

/// Means of the cells: a row for each subject, a column for each combination of the factors.
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
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  return means;
}

/// The means as observations again: one value of every subject in every cell.
Observations averaged(const Observations& observations, const Eigen::MatrixXd& means,
                      std::vector<std::string> factors, const std::string& subject) {
  factors.insert(factors.begin(), subject);
  Observations result{observations.response, {}, {}};
  for (const std::string& name : factors) {
    const Factor& factor = observations.factor(name);
    result.factors.push_back({name, factor.levels, {}, name == subject});
  }
  const auto all = cells(observations, factors);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result.values.push_back(means(at / means.cols(), at % means.cols()));
    for (std::size_t k = 0; k < factors.size(); ++k) result.factors[k].level.push_back(all[i].levels[k]);
  }
  return result;
}

/// Helmert's contrasts: orthonormal columns that sum to zero.
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

/// The contrasts between cells of which a term is made.
Eigen::MatrixXd contrasts_of(const Term& term, const Observations& observations,
                             const std::vector<std::string>& within) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Ones(1, 1);
  for (const std::string& name : within) {
    const auto levels = static_cast<Eigen::Index>(observations.factor(name).levels.size());
    const bool varies = std::find(term.factors.begin(), term.factors.end(), name) != term.factors.end();
    const Eigen::MatrixXd mean =
        Eigen::MatrixXd::Constant(levels, 1, 1.0 / std::sqrt(static_cast<double>(levels)));
    result = kronecker(result, varies ? contrasts(levels) : mean);
  }
  return result;
}

/// Mauchly's W and its probability after Box's expansion to the second order (Anderson 1958, section 10.7).
void judge_sphericity(Sphericity& result, const Eigen::MatrixXd& covariance, double freedom) {
  const auto p = static_cast<double>(covariance.rows());
  result.mauchly = covariance.determinant() / std::pow(covariance.trace() / p, p);
  const double rho = 1.0 - (2.0 * p * p + p + 2.0) / (6.0 * p * freedom);
  const double second = (p + 2.0) * (p - 1.0) * (p - 2.0) * (2.0 * p * p * p + 6.0 * p * p + 3.0 * p + 2.0) /
                        (288.0 * std::pow(freedom * p * rho, 2));
  const double z = -freedom * rho * std::log(result.mauchly), f = 0.5 * p * (p + 1.0) - 1.0;
  const double first = chi_squared_tail(z, f);
  result.p_mauchly = first + second * (chi_squared_tail(z, f + 4.0) - first);
}

Sphericity sphericity(const Eigen::MatrixXd& scores, const AnovaRow& row) {
  const Eigen::MatrixXd centred = scores.rowwise() - scores.colwise().mean();
  const auto freedom = static_cast<double>(scores.rows() - 1);
  const Eigen::MatrixXd covariance = centred.transpose() * centred / freedom;
  const auto p = static_cast<double>(scores.cols());
  Sphericity result;
  result.epsilon = std::pow(covariance.trace(), 2) / (p * covariance.squaredNorm());
  result.p_corrected =
      fisher_tail(row.f, row.freedom * result.epsilon, row.freedom * freedom * result.epsilon);
  result.mauchly = result.p_mauchly = std::numeric_limits<double>::quiet_NaN();
  if (freedom >= p) judge_sphericity(result, covariance, freedom);
  return result;
}

void warn(Anova& result, const AnovaRow& row) {
  const Sphericity& s = *row.sphericity;
  if (s.epsilon >= doubtful_epsilon && !(s.p_mauchly < significant)) return;
  const std::string mauchly = std::isnan(s.p_mauchly) ? "" : fmt::format(", Mauchly's P {:.2g}", s.p_mauchly);
  result.warnings.push_back(
      fmt::format("'{}' is not spherical (Greenhouse-Geisser epsilon {:.3f}{}): read the corrected P, {:.3g}",
                  row.name, s.epsilon, mauchly, s.p_corrected));
}

}  // namespace

Anova repeated_measures(const Observations& observations, const std::vector<std::string>& within,
                        const std::string& subject) {
  observations.check();
  if (observations.factor(subject).levels.size() < 2)
    throw StatisticsError(fmt::format("repeated measures need two subjects or more; '{}' has one", subject));
  const Eigen::MatrixXd means = cell_means(observations, within, subject);
  const auto terms = within_subject_terms(within, subject);
  Anova result = anova(averaged(observations, means, within, subject), terms);
  for (const Term& term : terms) {
    if (term.against.empty()) continue;
    for (AnovaRow& row : result.terms)
      if (row.name == term.name() && row.freedom > 1.0) {
        row.sphericity = sphericity(means * contrasts_of(term, observations, within), row);
        warn(result, row);
      }
  }
  return result;
}

}  // namespace stepwire
