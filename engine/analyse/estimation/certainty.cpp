#include "engine/analyse/estimation/certainty.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/distributions.hpp"

namespace stepwire::estimation {
namespace {

// Differences of runs have an error of about 1e-8 of a column; determined directions are larger.
constexpr double negligible = 1e-6;

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

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double part_of_direction = 0.02;  // least component of an unknown in a direction

/// Returns "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// True if an unknown takes part in a free direction.
bool open(const Resolution& resolved, Eigen::Index unknown) {
  return resolved.unknown[unknown] > part_of_direction;
}

/// Returns the standard errors from a covariance of the scaled unknowns; nan for unknowns in a free
/// direction.
Eigen::VectorXd errors_of(const Resolution& resolved, const Eigen::MatrixXd& known) {
  Eigen::VectorXd errors = known.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseQuotient(resolved.lengths);
  for (Eigen::Index i = 0; i < errors.size(); ++i)
    if (open(resolved, i)) errors[i] = nan;
  return errors;
}

/// Sets the results that depend on the chosen covariance of the scaled unknowns.
void choose(const Resolution& resolved, const Eigen::MatrixXd& known, Certainty& result) {
  const Eigen::VectorXd parts = resolved.lengths.cwiseInverse();
  const Eigen::Index count = parts.size();
  result.covariance = parts.asDiagonal() * known * parts.asDiagonal();
  result.standard_errors = errors_of(resolved, known);
  const Eigen::VectorXd deviations = known.diagonal().cwiseMax(1e-300).cwiseSqrt();
  result.correlation.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      result.correlation(i, j) =
          open(resolved, i) || open(resolved, j) ? nan : known(i, j) / (deviations[i] * deviations[j]);
  result.half_widths = result.quantile * result.standard_errors;
}

/// Returns the free directions as relative changes of the unknowns, scaled to a maximum of 1.
std::vector<Eigen::VectorXd> relative_directions(const Resolution& resolved, const Eigen::VectorXd& sizes) {
  std::vector<Eigen::VectorXd> directions;
  for (const Eigen::VectorXd& direction : resolved.free) {
    directions.push_back(direction.cwiseQuotient(resolved.lengths).cwiseQuotient(sizes));
    directions.back() /= directions.back().cwiseAbs().maxCoeff();
  }
  return directions;
}

/// Returns the quantile of Student's t for 95 %; `inflation` rows count as one.
double quantile_of(double freedom, Eigen::Index rows, double inflation) {
  const auto count = static_cast<double>(rows);
  return statistics::student_quantile(0.975, std::max(1.0, freedom - count + count / inflation));
}

/// Returns (J' J)^-1 S (J' J)^-1 of the scaled unknowns.
Eigen::MatrixXd serial_covariance(const Resolution& resolved, const Eigen::VectorXd& residuals,
                                  double freedom, const SerialCorrelation& serial,
                                  const std::vector<Eigen::Index>& starts) {
  const Eigen::MatrixXd terms = residuals.asDiagonal() * resolved.scaled;
  return static_cast<double>(residuals.size()) / freedom * resolved.inverse *
         serial.covariance_of_sum(terms, starts) * resolved.inverse;
}

/// True where all unknowns of a direction have the same absolute value, so that a sum of them and a product
/// have the same derivatives.
bool are_alike(const Eigen::VectorXd& direction, const Eigen::VectorXd& values) {
  constexpr double same = 0.02;
  if (values.size() == 0) return false;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction[i]) < part_of_direction) continue;
    least = std::min(least, std::abs(values[i]));
    most = std::max(most, std::abs(values[i]));
  }
  return most - least <= same * most;
}

/// Describes parameters whose joint change has no effect. Without `changes` all change by the same
/// percentage.
std::string combination_text(const std::vector<std::string>& up, const std::vector<std::string>& down,
                             const std::vector<std::string>& all, const std::vector<std::string>& changes,
                             bool alike) {
  const bool even = changes.empty();
  if (even && all.size() == 2 && alike)
    return fmt::format("only the {} of {} can be known, which are equally large; fix one of them",
                       up.size() == 1 ? "product or sum" : "ratio or difference", listed(all));
  if (even && all.size() == 2)
    return fmt::format("only the {} of {} can be known; fix one of them",
                       up.size() == 1 ? "product" : "ratio", listed(all));
  if (even && (up.size() == 1 || down.size() == 1))
    return fmt::format("only the products of {} with {} can be known; fix one of them",
                       listed(up.size() == 1 ? up : down), listed(up.size() == 1 ? down : up));
  if (even) return fmt::format("only combinations of {} can be known; fix one of them", listed(all));
  return fmt::format(
      "only combinations of {} can be known, since {} together change nothing; fix one of them", listed(all),
      listed(changes));
}

}  // namespace

Resolution Resolution::of(const RowMajor& jacobian) {
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

Certainty certainty_of(const Eigen::VectorXd& residuals, const RowMajorMatrix& jacobian,
                       const Eigen::VectorXd& sizes, double freedom, const RowOrder& order) {
  const Resolution resolved = Resolution::of(jacobian);
  Certainty result;
  result.deviation = residuals.norm() / std::sqrt(freedom);
  result.free_directions = relative_directions(resolved, sizes);
  result.serial = SerialCorrelation::of(residuals, order.starts);
  const Eigen::MatrixXd independent = result.deviation * result.deviation * resolved.inverse;
  result.classical = errors_of(resolved, independent);
  const bool together = order.in_time && result.serial.rows > 0;
  const Eigen::MatrixXd serial =
      together ? serial_covariance(resolved, residuals, freedom, result.serial, order.starts) : independent;
  if (order.in_time) result.of_series = errors_of(resolved, serial);
  const bool chosen = together && order.use == StandardErrors::serial;
  result.quantile = quantile_of(freedom, residuals.size(), chosen ? result.serial.inflation : 1.0);
  choose(resolved, chosen ? serial : independent, result);
  return result;
}

std::string in_words(const Eigen::VectorXd& direction, const std::vector<std::string>& names,
                     bool known_before, const Eigen::VectorXd& values) {
  std::vector<std::string> up, down, changes, all;
  bool even = true;  // all by the same percentage
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction[i]) < part_of_direction) continue;
    const std::string& name = names[static_cast<std::size_t>(i)];
    (direction[i] > 0.0 ? up : down).push_back(name);
    all.push_back(name);
    changes.push_back(fmt::format("{} {:+.2g} %", name, direction[i]));
    even = even && std::abs(std::abs(direction[i]) - 1.0) < 0.02;
  }
  if (all.size() == 1)
    return fmt::format("{} moves nothing that is compared where the search has ended; {}", all.front(),
                       elsewhere);
  if (known_before)
    return fmt::format(
        "only combinations of {} can be known where the search has ended, but each at its start; {}",
        listed(all), elsewhere);
  return combination_text(up, down, all, even ? std::vector<std::string>{} : changes,
                          are_alike(direction, values));
}

}  // namespace stepwire::estimation
