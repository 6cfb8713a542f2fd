#include "engine/analyse/estimation/trust_region.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::estimation {

LinearModel::LinearModel(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residuals)
    : slopes_(slopes), residuals_(residuals) {
  const Eigen::Index count = slopes.cols();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(slopes);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullU | Eigen::ComputeFullV);
  values_ = svd.singularValues();
  const double zero =
      std::numeric_limits<double>::epsilon() * static_cast<double>(slopes.rows()) * values_.maxCoeff();
  values_ = (values_.array() > zero).select(values_, 0.0);
  right_ = svd.matrixV();
  left_ = qr.householderQ() * Eigen::MatrixXd::Identity(slopes.rows(), count) * svd.matrixU();
  along_ = left_.transpose() * residuals;
}

Eigen::VectorXd LinearModel::damped(const Eigen::VectorXd& along, double damping) const {
  Eigen::VectorXd parts = Eigen::VectorXd::Zero(along.size());
  for (Eigen::Index i = 0; i < parts.size(); ++i)
    if (values_[i] > 0.0) parts[i] = -values_[i] * along[i] / (values_[i] * values_[i] + damping);
  return right_ * parts;
}

/// Finds the damping by Newton's method on 1/|s| = 1/radius within bounds (J. J. More 1978). The radius is
/// met to one per cent, where More allows ten.
double LinearModel::damping_for(double radius) const {
  const Eigen::ArrayXd s = values_.array(), force = s * along_.array();
  double low = 0.0, high = force.matrix().norm() / radius, damping = 1e-3 * high;
  constexpr int most = 30;
  for (int k = 0; k < most; ++k) {
    if (damping <= low || damping > high) damping = std::max(1e-3 * high, std::sqrt(low * high));
    const Eigen::ArrayXd below = s.square() + damping;
    const double length = (force / below).matrix().norm(), excess = length - radius;
    if (std::abs(excess) <= 0.01 * radius) break;
    (excess < 0.0 ? high : low) = damping;
    const double slope = -(force.square() / below.cube()).sum() / length;
    damping -= length / radius * excess / slope;
  }
  return damping;
}

Eigen::VectorXd LinearModel::step(double radius) {
  damping_ = 0.0;
  Eigen::VectorXd whole = damped(along_, 0.0);
  if (whole.norm() <= radius) return whole;
  damping_ = damping_for(radius);
  Eigen::VectorXd result = damped(along_, damping_);
  return result * std::min(1.0, radius / result.norm());
}

Eigen::VectorXd LinearModel::answer(const Eigen::VectorXd& change) const {
  return damped(left_.transpose() * change, damping_);
}

double LinearModel::gain(const Eigen::VectorXd& step) const {
  const Eigen::VectorXd moved = slopes_ * step;
  return -moved.dot(residuals_ + 0.5 * moved);
}

}  // namespace stepwire::estimation
