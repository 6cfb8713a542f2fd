#include "engine/analyse/estimation/serial_correlation.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::estimation {

namespace {

constexpr Eigen::Index longest = 2000;  // rows; a longer correlation means a wrong model

/// Calls visit(first, count) for each segment.
template <class Visit>
void each_stretch(Eigen::Index rows, const std::vector<Eigen::Index>& starts, const Visit& visit) {
  for (std::size_t i = 0; i < starts.size(); ++i)
    visit(starts[i], (i + 1 < starts.size() ? starts[i + 1] : rows) - starts[i]);
}

double autocovariance(const Eigen::VectorXd& r, const std::vector<Eigen::Index>& starts, Eigen::Index lag) {
  double sum = 0.0;
  each_stretch(r.size(), starts, [&](Eigen::Index first, Eigen::Index count) {
    if (count > lag) sum += r.segment(first, count - lag).dot(r.segment(first + lag, count - lag));
  });
  return sum;
}

}  // namespace

SerialCorrelation SerialCorrelation::of(const Eigen::VectorXd& residuals,
                                        const std::vector<Eigen::Index>& starts) {
  SerialCorrelation result;
  const double all = autocovariance(residuals, starts, 0);
  if (!(all > 0.0)) return result;
  const double chance = 2.0 * std::sqrt(2.0 / static_cast<double>(residuals.size()));
  Eigen::Index shortest = residuals.size();
  each_stretch(residuals.size(), starts,
               [&](Eigen::Index, Eigen::Index count) { shortest = std::min(shortest, count); });
  const Eigen::Index most = std::min(longest, shortest / 4);
  for (Eigen::Index lag = 1; lag + 1 <= most; lag += 2) {
    const double pair =
        (autocovariance(residuals, starts, lag) + autocovariance(residuals, starts, lag + 1)) / all;
    if (pair <= chance) break;
    result.rows = lag + 1;
    result.inflation += 2.0 * pair;
  }
  return result;
}

Eigen::MatrixXd SerialCorrelation::covariance_of_sum(const Eigen::MatrixXd& terms,
                                                     const std::vector<Eigen::Index>& starts) const {
  // Bartlett's weights 1 - lag/width result from summing all windows of that width, including those that
  // extend beyond an end.
  const Eigen::Index width = 3 * rows + 1;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(terms.cols(), terms.cols());
  each_stretch(terms.rows(), starts, [&](Eigen::Index first, Eigen::Index count) {
    Eigen::RowVectorXd window = Eigen::RowVectorXd::Zero(terms.cols());
    Eigen::MatrixXd windows(count + width - 1, terms.cols());
    for (Eigen::Index k = 0; k < count + width - 1; ++k) {
      if (k < count) window += terms.row(first + k);
      if (k >= width) window -= terms.row(first + k - width);
      windows.row(k) = window;
    }
    sum += windows.transpose() * windows;
  });
  return sum / static_cast<double>(width);
}

}  // namespace stepwire::estimation
