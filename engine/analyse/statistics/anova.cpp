#include "engine/analyse/statistics/anova.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/equal_variances.hpp"
#include "engine/analyse/statistics/linear_model.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/statistics/tail.hpp"

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

/// The terms beyond which a term is judged.
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

/// A sum of squares; 0 where it is but the rounding of scores whose squares sum to `all`.
double beyond_rounding(double sum, double all) {
  return is_rounding(std::sqrt(sum), std::sqrt(all)) ? 0.0 : sum;
}

AnovaRow line(const std::string& name, double freedom, double sum) {
  return {name, freedom, sum, freedom > 0.0 ? sum / freedom : no_number, no_number, no_number, no_number, ""};
}

/// The sums of squares of all terms, of what they leave and of both; `squares` is that of the scores.
void add_rows(Anova& result, const Eigen::VectorXd& response, double squares,
              const std::vector<TermColumns>& model) {
  const auto freedom_of_all = static_cast<double>(response.size() - 1);
  std::vector<const TermColumns*> all;
  double left = freedom_of_all;
  for (std::size_t i = 0; i < model.size(); ++i) {
    const auto freedom = static_cast<double>(model[i].columns.cols());
    const double sum =
        freedom > 0.0 ? beyond_rounding(sum_of_squares(response, model, i, result.sums), squares) : no_number;
    result.terms.push_back(line(model[i].term.name(), freedom, sum));
    all.push_back(&model[i]);
    left -= freedom;
  }
  const double rest = left > 0.0 ? (response - explained(response, all)).squaredNorm() : 0.0;
  result.residual = line("residual", left, beyond_rounding(rest, squares));
  result.total = line("total", freedom_of_all,
                      beyond_rounding((response.array() - response.mean()).square().sum(), squares));
}

void judge(AnovaRow& row, const AnovaRow& error) {
  row.against = error.name;
  if (row.freedom <= 0.0 || error.freedom <= 0.0) return;
  if (error.sum_of_squares <= 0.0) return;  // nothing to compare with, as a t test of equal differences
  row.f = row.mean_square / error.mean_square;
  row.p = fisher_tail(row.f, row.freedom, error.freedom);
  row.partial_eta_squared = row.sum_of_squares / (row.sum_of_squares + error.sum_of_squares);
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

/// Names the terms without F because what they are compared with does not vary.
void warn_of_missing_f(Anova& result) {
  std::vector<std::string> names;
  for (const AnovaRow& row : result.terms) {
    const AnovaRow* error = row.against == result.residual.name ? &result.residual : result.find(row.against);
    if (error && row.freedom > 0.0 && error->freedom > 0.0 && std::isnan(row.f)) names.push_back(row.name);
  }
  if (!names.empty())
    result.warnings.push_back(
        fmt::format("F of {} has no value: what it is compared with varies by no more than rounding",
                    fmt::join(names, ", ")));
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

/// Factors of the model that are treatments.
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

void describe_design(Anova& result, const Observations& observations, const std::vector<std::string>& names) {
  const auto all = cells(observations, names);
  std::size_t least = observations.values.size(), most = 0, empty = 0;
  for (const Cell& cell : all) {
    if (cell.values.empty()) ++empty;
    most = std::max(most, cell.values.size());
    if (!cell.values.empty()) least = std::min(least, cell.values.size());
  }
  result.balanced = empty == 0 && least == most;
  const std::string each = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
  result.design =
      fmt::format("{} values in {} cells of {}", observations.values.size(), all.size() - empty, each);
  if (empty > 0) result.design += fmt::format("; {} of {} combinations were not observed", empty, all.size());
}

void warn_of_variances(Anova& result, const Observations& observations,
                       const std::vector<std::string>& names) {
  std::vector<std::vector<double>> groups;
  for (Cell& cell : cells(observations, names)) groups.push_back(std::move(cell.values));
  const auto test = variance_test(groups);
  if (test && test->p < 0.05)
    result.warnings.push_back(fmt::format(
        "the variances of the cells differ (Brown-Forsythe F({:g}, {:g}) = {:.3g}, P = {:.2g}); an "
        "analysis of variance takes them for equal",
        test->above, test->below, test->f, test->p));
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
  // Squares of the differences from one of the values keep the digits that a large mean would take.
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
  describe_design(result, observations, names);
  warn_of_variances(result, observations, names);
  return result;
}

}  // namespace stepwire::statistics
