#include "engine/analyse/tuning/resolution.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "engine/analyse/tuning/target_search.hpp"

namespace stepwire::tuning {

namespace {

constexpr double seen = 1.0;        // Least singular value of a direction that moves the targets.
constexpr double least_part = 0.1;  // Least component of a parameter that takes part in a direction.
constexpr double of_normal = 1.96;  // Half a 95 % interval in standard deviations.

/// Returns the 95 % interval of a parameter from the variance of its share, limited to the bounds.
std::array<double, 2> interval_of(const TuneParameter& parameter, double value, double variance) {
  const double share = parameter.share_of(value), half = of_normal * std::sqrt(variance);
  std::array<double, 2> ends{parameter.at(std::max(0.0, share - half)),
                             parameter.at(std::min(1.0, share + half))};
  std::ranges::sort(ends);
  return ends;
}

/// Returns the names of the parameters that take part in a direction.
std::string free_direction(const Eigen::VectorXd& direction, const TuneRequest& request) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const double sign = direction[largest] < 0.0 ? -1.0 : 1.0;
  std::string text;
  for (std::size_t i = 0; i < request.parameters.size(); ++i) {
    const double part = sign * direction[static_cast<Eigen::Index>(i)];
    if (std::abs(part) >= least_part)
      text += fmt::format("{}{:+.2f} {}", text.empty() ? "" : ", ", part, request.parameters[i].name);
  }
  return fmt::format("the targets leave a direction free, by shares of the bounds: {}", text);
}

/// Adds singular values, intervals and free directions.
void decompose(const TuneRequest& request, const Values& values, Resolution& result) {
  const auto rows = static_cast<Eigen::Index>(request.targets.size());
  const auto count = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd jacobian(rows, count);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 0; k < count; ++k)
      jacobian(i, k) = result.jacobian[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count), open = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double value = k < svd.singularValues().size() ? svd.singularValues()[k] : 0.0;
    const Eigen::VectorXd direction = svd.matrixV().col(k);
    result.singular_values.push_back(value);
    if (value >= seen) {
      variance += direction.cwiseAbs2() / (value * value);
      continue;
    }
    open = open.cwiseMax(direction.cwiseAbs());
    result.findings.push_back(free_direction(direction, request));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.intervals.push_back(
        open[k] >= least_part ? std::nullopt
                              : std::optional(interval_of(request.parameters[i], values[i], variance[k])));
  }
}

}  // namespace

Resolution resolution_of(const TuneRuns& runs, const TuneRequest& request, const Values& values,
                         unsigned threads) {
  Resolution result;
  Evaluation last;
  const LookAt look = [&](const Shares& shares) -> const Evaluation& {
    Values at;
    for (std::size_t i = 0; i < shares.size(); ++i) at.push_back(request.parameters[i].at(shares[i]));
    return last = evaluate(runs, request, std::move(at), threads);
  };
  Shares shares;
  for (std::size_t i = 0; i < values.size(); ++i) shares.push_back(request.parameters[i].share_of(values[i]));
  std::size_t without = 0;
  auto jacobian = target_jacobian(look, request, shares, without);
  if (!jacobian && !runs.interrupted())
    result.findings.push_back(
        fmt::format("beside what was found {} gives nothing to compare, so that there are no intervals",
                    request.parameters[without].name));
  if (!jacobian || runs.interrupted()) return result;
  result.jacobian = std::move(*jacobian);
  decompose(request, values, result);
  return result;
}

}  // namespace stepwire::tuning
