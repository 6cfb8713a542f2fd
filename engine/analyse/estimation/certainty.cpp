#include "engine/analyse/estimation/certainty.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/student.hpp"

namespace stepwire::estimation {

namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Differences of runs leave some 1e-8 of a column; what is known at all stands out of that.
constexpr double negligible = 1e-6;
constexpr double part_of_direction = 0.02;  // below, an unknown does not take part

/// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// Which combinations of the unknowns a Jacobian determines, with its columns scaled to length 1.
struct Resolution {
  Eigen::VectorXd lengths;  ///< of the columns
  Eigen::MatrixXd scaled;
  Eigen::MatrixXd inverse;  ///< of the scaled J' J, the free directions left out
  Eigen::VectorXd unknown;  ///< the largest part of each unknown in a free direction
  std::vector<Eigen::VectorXd> free;
};

Resolution resolution_of(const RowMajorMatrix& jacobian) {
  const Eigen::Index count = jacobian.cols();
  Resolution result;
  result.lengths = jacobian.colwise().norm().transpose().cwiseMax(1e-300);
  result.scaled = jacobian * result.lengths.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(result.scaled);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
  result.inverse = Eigen::MatrixXd::Zero(count, count);
  result.unknown = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd v = svd.matrixV().col(k);
    const double value = svd.singularValues()[k];
    if (value > negligible * svd.singularValues()[0]) {
      result.inverse += v * v.transpose() / (value * value);
      continue;
    }
    result.unknown = result.unknown.cwiseMax(v.cwiseAbs());
    result.free.push_back(v);
  }
  return result;
}

/// What follows from the covariance of the scaled unknowns.
void set_errors(const Resolution& resolved, const Eigen::MatrixXd& known, Certainty& result) {
  const Eigen::VectorXd& lengths = resolved.lengths;
  const Eigen::Index count = lengths.size();
  result.covariance = lengths.cwiseInverse().asDiagonal() * known * lengths.cwiseInverse().asDiagonal();
  const Eigen::VectorXd deviations = known.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const auto open = [&](Eigen::Index i) { return resolved.unknown[i] > part_of_direction; };
  result.standard_errors.resize(count);
  result.correlation.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    result.standard_errors[i] = open(i) ? nan : deviations[i] / lengths[i];
    for (Eigen::Index j = 0; j < count; ++j)
      result.correlation(i, j) = open(i) || open(j) ? nan : known(i, j) / (deviations[i] * deviations[j]);
  }
  result.half_widths = result.quantile * result.standard_errors;
}

}  // namespace

Certainty certainty_of(const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian,
                       const Eigen::VectorXd& sizes, double freedom,
                       const std::vector<Eigen::Index>& starts) {
  const Resolution resolved = resolution_of(jacobian);
  Certainty result;
  result.deviation = residuals.norm() / std::sqrt(freedom);
  for (const Eigen::VectorXd& direction : resolved.free) {
    result.free_directions.push_back(direction.cwiseQuotient(resolved.lengths).cwiseQuotient(sizes));
    result.free_directions.back() /= result.free_directions.back().cwiseAbs().maxCoeff();
  }
  result.serial = SerialCorrelation::of(residuals, starts);
  const double rows = static_cast<double>(residuals.size());
  const double worth = std::max(1.0, freedom - rows + rows / result.serial.inflation);
  result.quantile = statistics::student_quantile(0.975, worth);
  Eigen::MatrixXd known = result.deviation * result.deviation * resolved.inverse;  // of the scaled unknowns
  if (result.serial.rows > 0) {
    const Eigen::MatrixXd terms = residuals.asDiagonal() * resolved.scaled;
    known =
        rows / freedom * resolved.inverse * result.serial.covariance_of_sum(terms, starts) * resolved.inverse;
  }
  set_errors(resolved, known, result);
  return result;
}

std::string in_words(const Eigen::VectorXd& direction, const std::vector<std::string>& names) {
  std::vector<std::string> up, down, changes, all;
  bool even = true;  // all by the same part
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction[i]) < part_of_direction) continue;
    const std::string& name = names[static_cast<std::size_t>(i)];
    (direction[i] > 0.0 ? up : down).push_back(name);
    all.push_back(name);
    changes.push_back(fmt::format("{} {:+.2g} %", name, direction[i]));
    even = even && std::abs(std::abs(direction[i]) - 1.0) < 0.02;
  }
  if (all.size() == 1) return fmt::format("{} moves nothing that is compared; fix it", all.front());
  if (even && all.size() == 2)
    return fmt::format("only the {} of {} can be known; fix one of them",
                       up.size() == 1 ? "product" : "ratio", listed(all));
  if (even && (up.size() == 1 || down.size() == 1))
    return fmt::format("only the products of {} with {} can be known; fix one of them",
                       listed(up.size() == 1 ? up : down), listed(up.size() == 1 ? down : up));
  return fmt::format(
      "only combinations of {} can be known, since {} together change nothing; fix one of them", listed(all),
      listed(changes));
}

}  // namespace stepwire::estimation
