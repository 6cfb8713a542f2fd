#include "engine/analyse/statistics/anova.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/anova_rows.hpp"
#include "engine/analyse/statistics/grouped.hpp"
#include "engine/analyse/statistics/linear_model.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

std::string joined_name(const std::vector<std::string>& factors) {
  return fmt::format("{}", fmt::join(factors, ":"));
}

bool contains(const Term& term, const Term& part) {
  return std::all_of(part.factors.begin(), part.factors.end(), [&](const std::string& name) {
    return std::find(term.factors.begin(), term.factors.end(), name) != term.factors.end();
  });
}

/// Returns the terms for which a term's sum of squares is adjusted.
std::vector<const TermColumns*> others(const std::vector<TermColumns>& model, std::size_t index,
                                       SumsOfSquares sums) {
  std::vector<const TermColumns*> result;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const bool before = sums == SumsOfSquares::sequential && i > index;
    const bool holds = sums == SumsOfSquares::hierarchical && contains(model[i].term, model[index].term);
    if (i != index && !before && !holds) result.push_back(&model[i]);
  }
  return result;
}

/// Sums of squares of a model of grouped observations.
class Sums {
 public:
  /// Here `squares` is the sum of squares of the scores; the share of rounding error in it counts as 0.
  Sums(const Grouped& observations, double squares, SumsOfSquares sums)
      : observations_(observations), squares_(squares), sums_(sums) {
    const std::vector<double>& means = observations.groups.values;
    response_ = Eigen::Map<const Eigen::VectorXd>(means.data(), static_cast<Eigen::Index>(means.size()))
                    .cwiseProduct(observations.roots);
  }

  /// Adds the rows of all terms, of the residual and of the total.
  void add_rows(Anova& result, const std::vector<TermColumns>& model) const {
    const double freedom_of_all = observations_.count - 1.0;
    std::vector<const TermColumns*> all;
    double left = freedom_of_all;
    for (std::size_t i = 0; i < model.size(); ++i) {
      const auto freedom = static_cast<double>(model[i].columns.cols());
      const double sum = freedom > 0.0 ? beyond_rounding(of_term(model, i), squares_) : no_number;
      result.terms.push_back(anova_row(model[i].term.name(), freedom, sum));
      all.push_back(&model[i]);
      left -= freedom;
    }
    const double rest =
        left > 0.0 ? observations_.within + (response_ - explained_by(all)).squaredNorm() : 0.0;
    result.residual = anova_row("residual", left, beyond_rounding(rest, squares_));
    result.total = anova_row("total", freedom_of_all, beyond_rounding(observations_.total, squares_));
  }

 private:
  Eigen::VectorXd explained_by(const std::vector<const TermColumns*>& terms) const {
    return explained(response_, terms, observations_.roots);
  }

  double of_term(const std::vector<TermColumns>& model, std::size_t index) const {
    auto terms = others(model, index, sums_);
    const Eigen::VectorXd without = explained_by(terms);
    terms.push_back(&model[index]);
    return (explained_by(terms) - without).squaredNorm();
  }

  const Grouped& observations_;
  Eigen::VectorXd response_;
  double squares_;
  SumsOfSquares sums_;
};

void judge_terms(Anova& result, const std::vector<Term>& terms) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (terms[i].against.empty()) {
      judge(result.terms[i], result.residual);
      continue;
    }
    const std::string name = joined_name(terms[i].against);
    const AnovaRow* error = result.find(name);
    if (error == nullptr)
      throw StatisticsError(
          fmt::format("'{}' is compared with '{}', which is no term of the model", terms[i].name(), name));
    judge(result.terms[i], *error);
  }
}

void warn_of_lost_terms(Anova& result, const std::vector<TermColumns>& model) {
  for (const TermColumns& term : model) {
    const auto left = term.columns.cols();
    if (left == term.wanted && term.wanted > 0) continue;
    const std::string name = term.term.name();
    if (term.wanted == 0)
      result.warnings.push_back(fmt::format("'{}' cannot be estimated: it has one level only", name));
    else
      result.warnings.push_back(fmt::format(
          "'{}' {}: in these data it follows from {}", name,
          left == 0 ? "cannot be estimated"
                    : fmt::format("has {} of its {} degrees of freedom", left, term.wanted),
          term.same_as.empty() ? "the others" : fmt::format("{}", fmt::join(term.same_as, " and "))));
  }
}

/// Returns the factors of the model that are treatments.
std::vector<std::string> treatments(const Observations& observations, const std::vector<Term>& terms) {
  std::vector<std::string> names;
  for (const Factor& factor : observations.factors) {
    const bool used = std::any_of(terms.begin(), terms.end(), [&](const Term& term) {
      return contains(term, Term{{factor.name}, {}});
    });
    if (used && !factor.subject) names.push_back(factor.name);
  }
  return names;
}

/// Returns the interactions of the treatments that the model does not contain.
std::vector<Term> pooled_terms(const std::vector<std::string>& treatments, const std::vector<Term>& terms) {
  std::vector<Term> pooled;
  for (const Term& term : crossed_terms(treatments))
    if (std::none_of(terms.begin(), terms.end(),
                     [&](const Term& one) { return contains(one, term) && contains(term, one); }))
      pooled.push_back(term);
  return pooled;
}

/// Adds a warning on interactions that the model pools in the residual, with the F they would have as terms.
void warn_of_pooled_terms(Anova& result, const Grouped& observations, const Sums& sums,
                          std::vector<Term> terms, const std::vector<std::string>& treatments) {
  const auto pooled = pooled_terms(treatments, terms);
  if (pooled.empty()) return;
  terms.insert(terms.end(), pooled.begin(), pooled.end());
  Anova whole;
  whole.sums = result.sums;
  sums.add_rows(whole, model_columns(observations.groups, terms));
  for (const Term& term : pooled)
    for (AnovaRow& row : whole.terms) {
      if (row.name != term.name() || row.freedom <= 0.0) continue;
      judge(row, whole.residual);
      if (std::isnan(row.f)) continue;
      result.warnings.push_back(fmt::format(
          "the interaction {} is part of the residual; as a term it has F({:g}, {:g}) = {:.3g}, P = {:.2g}",
          row.name, row.freedom, whole.residual.freedom, row.f, row.p));
    }
}

}  // namespace

std::string Term::name() const {
  return joined_name(factors);
}

const AnovaRow* Anova::find(const std::string& name) const {
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const AnovaRow& row) { return row.name == name; });
  return found == terms.end() ? nullptr : &*found;
}

std::string words_of(SumsOfSquares sums) {
  switch (sums) {
    case SumsOfSquares::sequential:
      return "type I (beyond the terms before)";
    case SumsOfSquares::hierarchical:
      return "type II (beyond the terms that do not contain it)";
    case SumsOfSquares::partial:
      break;
  }
  return "type III (beyond all other terms)";
}

Anova anova(const Observations& observations, const std::vector<Term>& terms, SumsOfSquares sums) {
  observations.check();
  double squares = 0.0;
  for (const double score : observations.values) squares += score * score;
  const Grouped groups = grouped(observations, terms);
  const Sums of_squares(groups, squares, sums);
  const auto model = model_columns(groups.groups, terms);
  Anova result;
  result.response = observations.response;
  result.sums = sums;
  of_squares.add_rows(result, model);
  judge_terms(result, terms);
  warn_of_missing_f(result);
  warn_of_lost_terms(result, model);
  const auto names = treatments(observations, terms);
  warn_of_pooled_terms(result, groups, of_squares, terms, names);
  describe_design(result, observations, names);
  warn_of_variances(result, observations, names);
  return result;
}

}  // namespace stepwire::statistics
