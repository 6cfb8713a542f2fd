#pragma once

#include <Eigen/Core>

namespace stepwire::estimation {

/// The linear model r + A s of residuals around a point, ready for steps of several lengths.
class LinearModel {
 public:
  /// More rows than columns.
  LinearModel(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residuals);

  /// The step s that makes |r + A s| least with |s| <= radius. Keeps the damping for accelerated().
  Eigen::VectorXd step(double radius);
  /// The step that answers a second-order change of the residuals, with the damping of the last step.
  Eigen::VectorXd answer(const Eigen::VectorXd& change) const;
  /// The part of half the squared residuals that the model loses by a step.
  double gain(const Eigen::VectorXd& step) const;

 private:
  Eigen::VectorXd damped(const Eigen::VectorXd& along, double damping) const;
  double damping_for(double radius) const;

  Eigen::MatrixXd slopes_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd left_, right_;  ///< singular vectors: A = left S right'
  Eigen::VectorXd values_;        ///< singular values; those within rounding of zero are zero
  Eigen::VectorXd along_;         ///< left' r
  double damping_ = 0.0;
};

}  // namespace stepwire::estimation
