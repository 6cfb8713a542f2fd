#include "engine/analyse/statistics/anova.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/anova_rows.hpp"
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

double sum_of_squares(const Eigen::VectorXd& response, const std::vector<TermColumns>& model,
                      std::size_t index, SumsOfSquares sums) {
  auto terms = others(model, index, sums);
  const Eigen::VectorXd without = explained(response, terms);
  terms.push_back(&model[index]);
  return (explained(response, terms) - without).squaredNorm();
}

/// Adds the sums of squares of all terms, of the residual and of the total; `squares` is that of the scores.
void add_rows(Anova& result, const Eigen::VectorXd& response, double squares,
              const std::vector<TermColumns>& model) {
  const auto freedom_of_all = static_cast<double>(response.size() - 1);
  std::vector<const TermColumns*> all;
  double left = freedom_of_all;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const auto freedom = static_cast<double>(model[i].columns.cols());
    const double sum =
        freedom > 0.0 ? beyond_rounding(sum_of_squares(response, model, i, result.sums), squares) : no_number;
    result.terms.push_back(anova_row(model[i].term.name(), freedom, sum));
    all.push_back(&model[i]);
    left -= freedom;
  }
  const double rest = left > 0.0 ? (response - explained(response, all)).squaredNorm() : 0.0;
  result.residual = anova_row("residual", left, beyond_rounding(rest, squares));
  result.total = anova_row("total", freedom_of_all,
                           beyond_rounding((response.array() - response.mean()).square().sum(), squares));
}

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
void warn_of_pooled_terms(Anova& result, const Observations& observations, const Eigen::VectorXd& response,
                          double squares, std::vector<Term> terms,
                          const std::vector<std::string>& treatments) {
  const auto pooled = pooled_terms(treatments, terms);
  if (pooled.empty()) return;
  terms.insert(terms.end(), pooled.begin(), pooled.end());
  Anova whole;
  whole.sums = result.sums;
  add_rows(whole, response, squares, model_columns(observations, terms));
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
  const auto count = static_cast<Eigen::Index>(observations.values.size());
  // Differences from the first value keep the digits that a large mean would cost.
  const Eigen::Map<const Eigen::VectorXd> scores(observations.values.data(), count);
  const Eigen::VectorXd response = scores.array() - observations.values[0];
  const auto model = model_columns(observations, terms);
  Anova result;
  result.response = observations.response;
  result.sums = sums;
  add_rows(result, response, scores.squaredNorm(), model);
  judge_terms(result, terms);
  warn_of_missing_f(result);
  warn_of_lost_terms(result, model);
  const auto names = treatments(observations, terms);
  warn_of_pooled_terms(result, observations, response, scores.squaredNorm(), terms, names);
  describe_design(result, observations, names);
  warn_of_variances(result, observations, names);
  return result;
}

}  // namespace stepwire::statistics
