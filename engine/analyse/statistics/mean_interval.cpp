#include "engine/analyse/statistics/mean_interval.hpp"

#include <cmath>

#include "engine/analyse/statistics/moments.hpp"
#include "engine/analyse/statistics/no_number.hpp"

namespace stepwire::statistics {
namespace {

ConfidenceInterval interval_about(const Eigen::VectorXd& values, double mean, double widening) {
  const auto count = static_cast<double>(values.size());
  const double variance = moments_of({values.begin(), values.end()}).squares / (count - 1.0);
  return student_interval(mean, widening * std::sqrt(variance / count), count - 1.0);
}

}  // namespace

std::vector<MeanInterval> mean_intervals(const Eigen::MatrixXd& values) {
  const auto conditions = static_cast<double>(values.cols());
  const Eigen::MatrixXd above = values.array() - values(0, 0);  // keeps the digits of a large mean
  const Eigen::MatrixXd normalised = above.colwise() - above.rowwise().mean();
  std::vector<MeanInterval> result;
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const double mean = moments_of({values.col(k).begin(), values.col(k).end()}).mean;
    MeanInterval interval{mean, interval_about(values.col(k), mean, 1.0), {no_number, no_number}};
    if (values.cols() > 1)
      interval.within_subject =
          interval_about(normalised.col(k), mean, std::sqrt(conditions / (conditions - 1.0)));
    result.push_back(interval);
  }
  return result;
}

}  // namespace stepwire::statistics
