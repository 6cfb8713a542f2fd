#include "engine/analyse/estimation/loss.hpp"

#include <cmath>

namespace stepwire::estimation {

Counted counted(double r, const FitRequest& request) {
  const double width = request.width, size = std::abs(r);
  if (request.loss == FitLoss::huber && size > width) {
    const double value = std::sqrt(width * (2.0 * size - width));
    return {std::copysign(value, r), width / value};
  }
  if (request.loss == FitLoss::cauchy && size > 1e-6 * width) {
    const double share = r * r / (width * width), value = width * std::sqrt(std::log1p(share));
    return {std::copysign(value, r), size / (1.0 + share) / value};
  }
  return {r, 1.0};
}

void count(const FitRequest& request, Eigen::VectorXd& residuals, Jacobian& jacobian) {
  if (request.loss == FitLoss::none) return;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const Counted one = counted(residuals[i], request);
    residuals[i] = one.value;
    if (jacobian.rows() == residuals.size()) jacobian.row(i) *= one.slope;
  }
}

double cost_of(const Eigen::VectorXd& residuals, const FitRequest& request) {
  double sum = 0.0;
  for (const double r : residuals) {
    const double value = counted(r, request).value;
    sum += value * value;
  }
  return 0.5 * sum;
}

}  // namespace stepwire::estimation
