#pragma once

#include <Eigen/Core>

namespace stepwire::estimation {

/// Linear model r + A s of residuals around a point, factorised for steps of several lengths.
class LinearModel {
 public:
  /// Factorises the model. A has more rows than columns.
  LinearModel(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residuals);

  /// Returns the step s that minimises |r + A s| subject to |s| <= radius. Its damping is kept for answer().
  Eigen::VectorXd step(double radius);
  /// Returns the step that compensates a second-order change of the residuals, with the damping of the last
  /// step.
  Eigen::VectorXd answer(const Eigen::VectorXd& change) const;
  /// Returns the decrease of half the squared residuals by a step, as the model predicts it.
  double gain(const Eigen::VectorXd& step) const;

 private:
  Eigen::VectorXd damped(const Eigen::VectorXd& along, double damping) const;
  double damping_for(double radius) const;

  Eigen::MatrixXd slopes_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd left_, right_;  ///< Singular vectors: A = left S right'.
  Eigen::VectorXd values_;        ///< Singular values; those within rounding error of zero are set to zero.
  Eigen::VectorXd along_;         ///< left' r
  double damping_ = 0.0;
};

}  // namespace stepwire::estimation
