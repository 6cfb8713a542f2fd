#include "engine/analyse/statistics/repeated_measures.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/contrasts.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire::statistics {
namespace {

constexpr double doubtful_epsilon = 0.75, significant = 0.05;

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

/// Huynh and Feldt 1976, at most 1; nan where there are too few subjects.
double huynh_feldt(double greenhouse_geisser, double terms, double freedom) {
  const double below = terms * (freedom - terms * greenhouse_geisser);
  if (below < 1e-9 * terms * freedom) return no_number;
  return std::min(1.0, ((freedom + 1.0) * terms * greenhouse_geisser - 2.0) / below);
}

double corrected_probability(const AnovaRow& row, double error_freedom, double epsilon) {
  if (std::isnan(epsilon) || std::isnan(row.f)) return no_number;
  return fisher_tail(row.f, row.freedom * epsilon, error_freedom * epsilon);
}

/// Nothing where the subjects differ in none of the contrasts of scores that have a size (their norm).
std::optional<Sphericity> sphericity(const Eigen::MatrixXd& scores, double size, const AnovaRow& row) {
  const Eigen::MatrixXd centred = scores.rowwise() - scores.colwise().mean();
  if (is_rounding(centred.norm(), size)) return std::nullopt;
  const auto freedom = static_cast<double>(scores.rows() - 1);
  const Eigen::MatrixXd covariance = centred.transpose() * centred / freedom;
  const auto p = static_cast<double>(scores.cols());
  Sphericity result;
  result.epsilon = std::pow(covariance.trace(), 2) / (p * covariance.squaredNorm());
  result.p_corrected = corrected_probability(row, row.freedom * freedom, result.epsilon);
  result.huynh_feldt = huynh_feldt(result.epsilon, p, freedom);
  result.p_huynh_feldt = corrected_probability(row, row.freedom * freedom, result.huynh_feldt);
  result.mauchly = result.p_mauchly = no_number;
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
        row.sphericity =
            sphericity(means * contrasts_of(term.factors, observations, within), means.norm(), row);
        if (row.sphericity) warn(result, row);
      }
  }
  return result;
}

}  // namespace stepwire::statistics
