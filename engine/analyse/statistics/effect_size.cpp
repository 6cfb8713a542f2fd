#include "engine/analyse/statistics/effect_size.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/noncentral.hpp"
#include "engine/analyse/statistics/rounding.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the quotient; nan for a divisor that is not positive.
double ratio(double above, double below) {
  return below > 0.0 ? above / below : no_number;
}

ConfidenceInterval interval_of(const AnovaRow& row, double error_freedom) {
  const ConfidenceInterval lambda = noncentrality_of_f(row.f, row.freedom, error_freedom);
  const double rest = row.freedom + error_freedom + 1.0;
  return {lambda.low / (lambda.low + rest), lambda.high / (lambda.high + rest)};
}

}  // namespace

PairedEffect paired_effect(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.size(); ++i) differences.push_back(first[i] - second[i]);
  const PairedTest test =
      paired_test(without_rounding(differences, std::max(largest_of(first), largest_of(second))));
  const double root = std::sqrt(test.freedom + 1.0);
  const ConfidenceInterval noncentrality = noncentrality_of_t(test.t, test.freedom);
  const double spread = 0.5 * (paired_test(first).deviation + paired_test(second).deviation);
  return {ratio(test.mean, test.deviation),
          {noncentrality.low / root, noncentrality.high / root},
          ratio(test.mean, spread)};
}

std::vector<TermEffect> term_effects(const Anova& repeated) {
  double between_subjects = 0.0;  // the subject and its interactions that are no term's error
  for (const AnovaRow& row : repeated.terms)
    if (repeated.find(row.against) == nullptr && row.freedom > 0.0) between_subjects += row.sum_of_squares;
  std::vector<TermEffect> effects;
  for (const AnovaRow& row : repeated.terms) {
    const AnovaRow* error = repeated.find(row.against);
    if (error == nullptr || row.freedom <= 0.0) continue;  // e.g. a factor of one level
    effects.push_back({row.name, row.partial_eta_squared, interval_of(row, error->freedom),
                       ratio(row.sum_of_squares, row.sum_of_squares + between_subjects)});
  }
  return effects;
}

}  // namespace stepwire::statistics
