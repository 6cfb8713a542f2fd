#include "engine/analyse/statistics/repeated_measures.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/contrasts.hpp"
#include "engine/analyse/statistics/distributions.hpp"
#include "engine/analyse/statistics/linear_model.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

constexpr double doubtful_epsilon = 0.75, significant = 0.05;

/// Returns the cell means as observations: one value per subject and cell.
Observations averaged(const Observations& subjects, const Eigen::MatrixXd& means, const Observations& scores,
                      const std::vector<std::string>& within) {
  Observations result{scores.response, {}, subjects.factors};
  for (Factor& factor : result.factors) factor.level.clear();
  for (const std::string& name : within) {
    const Factor& factor = scores.factor(name);
    result.factors.push_back({name, factor.levels, {}, false});
  }
  const auto all = cells(
      Observations{
          "", {}, {result.factors.end() - static_cast<std::ptrdiff_t>(within.size()), result.factors.end()}},
      within);
  const std::size_t own = subjects.factors.size();
  for (Eigen::Index s = 0; s < means.rows(); ++s)
    for (std::size_t c = 0; c < all.size(); ++c) {
      result.values.push_back(means(s, static_cast<Eigen::Index>(c)));
      for (std::size_t k = 0; k < own; ++k)
        result.factors[k].level.push_back(subjects.factors[k].level[static_cast<std::size_t>(s)]);
      for (std::size_t k = 0; k < within.size(); ++k)
        result.factors[own + k].level.push_back(all[c].levels[k]);
    }
  return result;
}

/// Returns the subjects as observations without values, with the between-subject factors. Throws
/// StatisticsError if a subject has two levels of such a factor.
Observations subjects_of(const Observations& scores, const std::vector<std::string>& between,
                         const std::string& subject) {
  const Factor& who = scores.factor(subject);
  Observations subjects{"", std::vector<double>(who.levels.size(), 0.0), {{subject, who.levels, {}, true}}};
  for (std::size_t s = 0; s < who.levels.size(); ++s) subjects.factors[0].level.push_back(s);
  for (const std::string& name : between) {
    const Factor& factor = scores.factor(name);
    Factor own{name, factor.levels, std::vector<std::size_t>(who.levels.size(), factor.levels.size()), false};
    for (std::size_t row = 0; row < scores.values.size(); ++row) {
      std::size_t& level = own.level[who.level[row]];
      if (level != factor.levels.size() && level != factor.level[row])
        throw StatisticsError(
            fmt::format("{} {} has values under two levels of '{}', {} and {}; a factor between subjects has "
                        "one for each",
                        subject, who.levels[who.level[row]], name, factor.levels[level],
                        factor.levels[factor.level[row]]));
      level = factor.level[row];
    }
    subjects.factors.push_back(std::move(own));
  }
  return subjects;
}

/// Linear model of the subjects: a constant and the between-subject terms.
class BetweenModel {
 public:
  BetweenModel(const Observations& subjects, const std::vector<std::string>& between)
      : terms_(model_columns(subjects, crossed_terms(between))),
        subjects_(static_cast<Eigen::Index>(subjects.values.size())) {}

  const std::vector<TermColumns>& terms() const { return terms_; }
  double freedom() const { return static_cast<double>(subjects_ - columns_without(-2).cols()); }
  Eigen::MatrixXd residuals(const Eigen::MatrixXd& scores) const { return scores - fitted(scores, -2); }
  /// Returns the sum of squares of a term beyond all others (-1: the constant), over all columns of scores.
  double sum(const Eigen::MatrixXd& scores, int term) const {
    return (fitted(scores, -2) - fitted(scores, term)).squaredNorm();
  }

 private:
  Eigen::MatrixXd columns_without(int term) const {
    Eigen::MatrixXd columns(subjects_, 0);
    const auto add = [&](const Eigen::MatrixXd& more) {
      columns.conservativeResize(Eigen::NoChange, columns.cols() + more.cols());
      columns.rightCols(more.cols()) = more;
    };
    if (term != -1) add(Eigen::MatrixXd::Ones(subjects_, 1));
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (static_cast<int>(i) != term) add(terms_[i].columns);
    return columns;
  }

  Eigen::MatrixXd fitted(const Eigen::MatrixXd& scores, int without) const {
    const Eigen::MatrixXd columns = columns_without(without);
    if (columns.cols() == 0) return Eigen::MatrixXd::Zero(scores.rows(), scores.cols());
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
    Eigen::MatrixXd along = qr.householderQ().adjoint() * scores;
    along.bottomRows(along.rows() - columns.cols()).setZero();
    return qr.householderQ() * along;
  }

  std::vector<TermColumns> terms_;
  Eigen::Index subjects_;
};

/// Sets Mauchly's W and its P by Box's expansion to the second order (Anderson 1958, section 10.7).
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

/// Returns the epsilon of Huynh and Feldt 1976, at most 1; nan for too few subjects.
double huynh_feldt(double greenhouse_geisser, double terms, double freedom) {
  const double below = terms * (freedom - terms * greenhouse_geisser);
  if (below < 1e-9 * terms * freedom) return no_number;
  return std::min(1.0, ((freedom + 1.0) * terms * greenhouse_geisser - 2.0) / below);
}

double corrected_probability(const AnovaRow& row, double error_freedom, double epsilon) {
  if (std::isnan(epsilon) || std::isnan(row.f)) return no_number;
  return fisher_tail(row.f, row.freedom * epsilon, error_freedom * epsilon);
}

/// Returns the sphericity of a term; std::nullopt if the subjects differ in none of its contrasts. Here
/// `rest` are the contrasts minus the between-subject model, with `freedom` degrees of freedom; `size` is the
/// norm of the scores.
std::optional<Sphericity> sphericity(const Eigen::MatrixXd& rest, double freedom, double size,
                                     const AnovaRow& row) {
  if (is_rounding(rest.norm(), size)) return std::nullopt;
  const Eigen::MatrixXd covariance = rest.transpose() * rest / freedom;
  const auto p = static_cast<double>(rest.cols());
  Sphericity result;
  result.epsilon = std::pow(covariance.trace(), 2) / (p * covariance.squaredNorm());
  result.p_corrected = corrected_probability(row, p * freedom, result.epsilon);
  result.huynh_feldt = huynh_feldt(result.epsilon, p, freedom);
  result.p_huynh_feldt = corrected_probability(row, p * freedom, result.huynh_feldt);
  result.mauchly = result.p_mauchly = no_number;
  if (freedom >= p) judge_sphericity(result, covariance, freedom);
  return result;
}

void warn(Anova& result, const AnovaRow& row) {
  const Sphericity& s = *row.sphericity;
  if (s.epsilon >= doubtful_epsilon && !(s.p_mauchly < significant)) return;
  const std::string verdict =
      std::isnan(s.p_mauchly) ? fmt::format("too few subjects to test whether '{}' is spherical", row.name)
      : s.p_mauchly < significant
          ? fmt::format("'{}' is not spherical (Mauchly's P {:.2g})", row.name, s.p_mauchly)
          : fmt::format(
                "Mauchly's test does not reject that '{}' is spherical (P {:.2g}), but with few subjects "
                "it misses much",
                row.name, s.p_mauchly);
  result.warnings.push_back(
      fmt::format("{}; its Greenhouse-Geisser epsilon is {:.3f}: read the corrected P, {:.3g}", verdict,
                  s.epsilon, s.p_corrected));
}

/// All lines of one design. Each within-subject term is reduced to orthonormal contrasts of the cell means,
/// one row per subject. The between-subject model is fitted to these contrasts. Its constant gives the line
/// of the term, its other terms give the interactions, and its residual is the error of both. This needs no
/// design matrix over all cells, and yields the covariances for the sphericity.
class Design {
 public:
  Design(const Observations& scores, std::vector<std::string> within, std::vector<std::string> between,
         const std::string& subject)
      : scores_(scores),
        within_(std::move(within)),
        subjects_(subjects_of(scores, between, subject)),
        model_(subjects_, between),
        subject_(subject),
        between_(std::move(between)) {
    const double first =
        scores.values[0];  // differences from it keep the digits that a large mean would cost
    Observations centred = scores;
    for (double& value : centred.values) value -= first;
    means_ = cell_means(centred, within_, subject);
    size_ = (means_.array() + first).matrix().norm();
    result_.response = scores.response;
  }

  Anova analyse() {
    if (model_.freedom() < 1.0)
      throw StatisticsError("there are as many groups as subjects; repeated measures need more subjects");
    std::vector<Term> all = crossed_terms(within_);
    all.insert(all.begin(), Term{});
    for (const Term& term : all) add(term);
    for (AnovaRow& error : errors_) result_.terms.push_back(std::move(error));
    result_.residual = anova_row("residual", 0.0, 0.0);
    const double total = (means_.array() - means_.mean()).square().sum();
    result_.total =
        anova_row("total", static_cast<double>(means_.size() - 1), beyond_rounding(total, size_ * size_));
    describe();
    return std::move(result_);
  }

 private:
  /// Adds the lines of a within-subject term, of its interactions with the between-subject terms, and of
  /// their error. Without factors these are the lines of the subjects' means.
  void add(const Term& within) {
    const Eigen::MatrixXd scores = means_ * contrasts_of(within.factors, scores_, within_);
    const Eigen::MatrixXd rest = model_.residuals(scores);
    const auto width = static_cast<double>(scores.cols());
    Term error = within;
    error.factors.push_back(subject_);
    errors_.push_back(line(error.name(), width * model_.freedom(), rest.squaredNorm()));
    std::vector<std::pair<AnovaRow, int>> lines;
    if (!within.factors.empty()) lines.emplace_back(line(within.name(), width, model_.sum(scores, -1)), -1);
    for (std::size_t i = 0; i < model_.terms().size(); ++i) {
      Term both = model_.terms()[i].term;
      both.factors.insert(both.factors.end(), within.factors.begin(), within.factors.end());
      const auto own = static_cast<double>(model_.terms()[i].columns.cols());
      lines.emplace_back(line(both.name(), width * own, model_.sum(scores, static_cast<int>(i))), i);
    }
    for (auto& [row, index] : lines) {
      judge(row, errors_.back());
      if (width > 1.0) row.sphericity = sphericity(rest, model_.freedom(), size_, row);
      if (row.sphericity) warn(result_, row);
      result_.terms.push_back(std::move(row));
    }
  }

  AnovaRow line(const std::string& name, double freedom, double sum) const {
    return anova_row(name, freedom, freedom > 0.0 ? beyond_rounding(sum, size_ * size_) : no_number);
  }

  void describe() {
    std::vector<std::string> names = between_;
    names.insert(names.end(), within_.begin(), within_.end());
    Observations cells = averaged(subjects_, means_, scores_, within_);
    describe_design(result_, cells, names);
    warn_of_missing_f(result_);
    warn_of_variances(result_, cells, names);
  }

  const Observations& scores_;
  std::vector<std::string> within_;
  Observations subjects_;
  BetweenModel model_;
  const std::string& subject_;
  std::vector<std::string> between_;
  Eigen::MatrixXd means_;  ///< [subject][cell]
  double size_ = 0.0;      ///< Norm of all scores.
  std::vector<AnovaRow> errors_;
  Anova result_;
};

}  // namespace

Anova repeated_measures(const Observations& observations, const std::vector<std::string>& within,
                        const std::string& subject, const std::vector<std::string>& between) {
  observations.check();
  if (observations.factor(subject).levels.size() < 2)
    throw StatisticsError(fmt::format("repeated measures need two subjects or more; '{}' has one", subject));
  return Design(observations, within, between, subject).analyse();
}

}  // namespace stepwire::statistics
