#include "engine/analyse/statistics/paired_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/distributions.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the standard deviation; 0 if the values differ by rounding only.
double deviation_of(const std::vector<double>& values) {
  const double deviation = std::sqrt(moments_of(values).squares / static_cast<double>(values.size() - 1));
  return is_rounding(deviation, largest_of(values)) ? 0.0 : deviation;
}

/// Returns the quotient; nan for a divisor that is not positive.
double ratio(double above, double below) {
  return below > 0.0 ? above / below : no_number;
}

ConfidenceInterval interval_of(const AnovaRow& row, double error_freedom) {
  const ConfidenceInterval lambda = noncentrality_of_f(row.f, row.freedom, error_freedom);
  const double rest = row.freedom + error_freedom + 1.0;
  return {lambda.low / (lambda.low + rest), lambda.high / (lambda.high + rest)};
}

/// Returns the share of all sign combinations whose positive ranks sum to `sum` or less. Tied ranks are
/// multiples of 1/2, so twice a rank is an integer.
double lower_tail(const std::vector<double>& ranks, double sum) {
  std::vector<double> ways{1.0};  // share of the signs so far by twice the rank sum
  for (const double rank : ranks) {
    const auto step = static_cast<std::size_t>(std::lround(2.0 * rank));
    ways.resize(ways.size() + step, 0.0);
    for (std::size_t i = ways.size(); i-- > 0;)
      ways[i] = 0.5 * (ways[i] + (i >= step ? ways[i - step] : 0.0));
  }
  double tail = 0.0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(std::lround(2.0 * sum)); ++i) tail += ways[i];
  return tail;
}

double exact_probability(const std::vector<double>& ranks, double sum) {
  double total = 0.0;
  for (const double rank : ranks) total += rank;
  return std::min(1.0, 2.0 * lower_tail(ranks, std::min(sum, total - sum)));  // the distribution is symmetric
}

double normal_probability(const std::vector<double>& ranks, double sum) {
  double mean = 0.0, variance = 0.0;
  for (const double rank : ranks) mean += 0.5 * rank, variance += 0.25 * rank * rank;
  const double beyond = std::max(0.0, std::abs(sum - mean) - 0.5);
  return std::min(1.0, std::erfc(beyond / std::sqrt(2.0 * variance)));
}

}  // namespace

ConfidenceInterval student_interval(double mean, double standard_error, double freedom) {
  if (!(freedom > 0.0)) return {no_number, no_number};
  const double reach = student_quantile(0.975, freedom) * standard_error;
  return {mean - reach, mean + reach};
}

PairedTest paired_test(const std::vector<double>& differences) {
  PairedTest test{no_number, no_number, no_number, no_number, no_number, {no_number, no_number}};
  if (differences.empty()) return test;
  const auto count = static_cast<double>(differences.size());
  test.mean = moments_of(differences).mean;
  if (differences.size() < 2) return test;
  test.freedom = count - 1.0;
  test.deviation = deviation_of(differences);
  const double error = test.deviation / std::sqrt(count);
  test.interval = student_interval(test.mean, error, test.freedom);
  if (error <= 0.0) return test;
  test.t = test.mean / error;
  test.p = fisher_tail(test.t * test.t, 1.0, test.freedom);
  return test;
}

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

SignedRank signed_rank_test(const std::vector<double>& differences, std::size_t largest_exact) {
  std::vector<double> kept, sizes;
  for (const double difference : differences)
    if (difference != 0.0) kept.push_back(difference), sizes.push_back(std::abs(difference));
  SignedRank test;
  test.count = kept.size();
  if (kept.empty()) {
    test.p = std::numeric_limits<double>::quiet_NaN();
    return test;
  }
  const auto ranked = ranks(sizes);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i] > 0.0) test.sum += ranked[i];
  test.exact = kept.size() <= largest_exact;
  test.p = test.exact ? exact_probability(ranked, test.sum) : normal_probability(ranked, test.sum);
  return test;
}

std::vector<double> holm_corrected(const std::vector<double>& probabilities) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    if (!std::isnan(probabilities[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probabilities[a] < probabilities[b]; });
  std::vector<double> corrected = probabilities;
  double before = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double raised = static_cast<double>(order.size() - i) * probabilities[order[i]];
    corrected[order[i]] = before = std::min(1.0, std::max(before, raised));
  }
  return corrected;
}

}  // namespace stepwire::statistics
