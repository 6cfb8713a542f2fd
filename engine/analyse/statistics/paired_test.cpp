#include "engine/analyse/statistics/paired_test.hpp"

#include <cmath>

#include "engine/analyse/statistics/moments.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/student.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the standard deviation; 0 if the values differ by rounding only.
double deviation_of(const std::vector<double>& values) {
  const double deviation = std::sqrt(moments_of(values).squares / static_cast<double>(values.size() - 1));
  return is_rounding(deviation, largest_of(values)) ? 0.0 : deviation;
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

}  // namespace stepwire::statistics
