#include "engine/analyse/estimation/still_falling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/certainty.hpp"

namespace stepwire::estimation {

namespace {

constexpr double flat = 1e-3;  // cosine; differences of runs with few correct digits have more than rounding

bool is_held(const FitParameter& parameter, double x, double gradient) {
  return (x <= parameter.lower && gradient > 0.0) || (x >= parameter.upper && gradient < 0.0);
}

}  // namespace

std::vector<FallingUnknown> still_falling(const Residuals& residuals, const FitRequest& request,
                                          const Eigen::VectorXd& x, const Eigen::VectorXd& r,
                                          const Jacobian& slopes) {
  std::vector<FallingUnknown> falling;
  const double size = r.norm();
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, r.size() - x.size()));
  const double least = std::max(flat, request.tolerance / std::sqrt(freedom));
  for (Eigen::Index i = 0; i < slopes.cols() && size > 0.0; ++i) {
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(i));
    const double length = slopes.col(i).norm(), gradient = slopes.col(i).dot(r);
    if (!(length > 0.0) || is_held(parameter, x[i], gradient)) continue;
    const double cosine = std::abs(gradient) / (length * size), change = cosine * size / length;
    const bool small = change <= request.tolerance * std::max(std::abs(x[i]), parameter.scale);
    if (cosine > least && !small) falling.push_back({i, cosine});
  }
  return falling;
}

std::string falling_text(const std::vector<FallingUnknown>& falling, const std::vector<std::string>& names) {
  std::vector<std::string> along;
  double most = 0.0;
  for (const FallingUnknown& one : falling) {
    along.push_back(names[static_cast<std::size_t>(one.unknown)]);
    most = std::max(most, one.cosine);
  }
  return fmt::format(
      "no minimum: the search has ended where the cost still falls along {} (cosine between residuals and "
      "derivatives up to {:.2g}, at a minimum 0); {}",
      fmt::join(along, ", "), most, elsewhere);
}

}  // namespace stepwire::estimation
