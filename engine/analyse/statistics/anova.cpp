#include "engine/analyse/statistics/anova.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "engine/analyse/statistics/assumptions.hpp"
#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/distributions.hpp"
#include "engine/analyse/statistics/linear_model.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/base/text/count.hpp"

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

/// Returns the indices of the factors that occur in a term.
std::vector<std::size_t> used_factors(const Observations& observations, const std::vector<Term>& terms) {
  for (const Term& term : terms)
    for (const std::string& name : term.factors) observations.factor(name);  // throws for an unknown one
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < observations.factors.size(); ++k)
    if (std::ranges::any_of(terms, [&](const Term& term) {
          return std::ranges::find(term.factors, observations.factors[k].name) != term.factors.end();
        }))
      used.push_back(k);
  return used;
}

/// Returns the values of each group, and adds the levels of the groups to the factors.
std::vector<std::vector<double>> values_by_group(const Observations& observations,
                                                 const std::vector<std::size_t>& used,
                                                 std::vector<Factor>& factors) {
  std::map<std::vector<std::size_t>, std::size_t> known;
  std::vector<std::vector<double>> values;
  for (std::size_t row = 0; row < observations.values.size(); ++row) {
    std::vector<std::size_t> levels;
    for (const std::size_t k : used) levels.push_back(observations.factors[k].level[row]);
    const auto [group, is_new] = known.emplace(levels, values.size());
    if (is_new) {
      values.emplace_back();
      for (std::size_t i = 0; i < used.size(); ++i) factors[i].level.push_back(levels[i]);
    }
    values[group->second].push_back(observations.values[row]);
  }
  return values;
}

/// Groups observations by the factors of some terms. Throws StatisticsError for an unknown factor.
Grouped grouped(const Observations& observations, const std::vector<Term>& terms) {
  const std::vector<std::size_t> used = used_factors(observations, terms);
  Grouped result;
  result.groups.response = observations.response;
  result.count = static_cast<double>(observations.values.size());
  for (const std::size_t k : used) {
    result.groups.factors.push_back(observations.factors[k]);
    result.groups.factors.back().level.clear();
  }
  const auto values = values_by_group(observations, used, result.groups.factors);
  result.roots.resize(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Moments moments = moments_of(values[i], observations.values[0]);
    result.groups.values.push_back(moments.above);
    result.within += moments.squares;
    result.roots[static_cast<Eigen::Index>(i)] = std::sqrt(static_cast<double>(values[i].size()));
  }
  result.total = moments_of(observations.values).squares;
  return result;
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

double beyond_rounding(double sum, double all) {
  return is_rounding(std::sqrt(sum), std::sqrt(all)) ? 0.0 : sum;
}

AnovaRow anova_row(const std::string& name, double freedom, double sum) {
  return {name, freedom, sum, freedom > 0.0 ? sum / freedom : no_number, no_number, no_number, no_number, ""};
}

void judge(AnovaRow& row, const AnovaRow& error) {
  row.against = error.name;
  if (row.freedom <= 0.0 || error.freedom <= 0.0) return;
  if (error.sum_of_squares <= 0.0) return;  // no error variance: F is undefined
  row.f = row.mean_square / error.mean_square;
  row.p = fisher_tail(row.f, row.freedom, error.freedom);
  row.partial_eta_squared = row.sum_of_squares / (row.sum_of_squares + error.sum_of_squares);
}

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
  result.design = fmt::format("{} in {} of {}", text::counted(observations.values.size(), "value"),
                              text::counted(all.size() - empty, "cell"), each);
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

std::vector<Term> additive_terms(const std::vector<std::string>& factors) {
  std::vector<Term> terms;
  for (const std::string& factor : factors) terms.push_back({{factor}, {}});
  return terms;
}

std::vector<Term> crossed_terms(const std::vector<std::string>& factors) {
  std::vector<Term> terms;
  for (std::uint64_t chosen = 1; chosen < std::uint64_t{1} << factors.size(); ++chosen) {
    Term term;
    for (std::size_t i = 0; i < factors.size(); ++i)
      if ((chosen >> i & 1U) != 0) term.factors.push_back(factors[i]);
    terms.push_back(std::move(term));
  }
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& a, const Term& b) { return a.factors.size() < b.factors.size(); });
  return terms;
}

}  // namespace stepwire::statistics
