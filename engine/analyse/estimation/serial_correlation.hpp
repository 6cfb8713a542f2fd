#pragma once

#include <Eigen/Core>
#include <vector>

namespace stepwire::estimation {

/// How long residuals go together. Errors of a model and filtered noise last over many rows, which then tell
/// less than their number; an interval that counts each of them would be too narrow.
struct SerialCorrelation {
  Eigen::Index rows = 0;   ///< over which they do; 0: they are independent
  double inflation = 1.0;  ///< so many rows are worth one

  /// Of residuals in stretches that begin at these rows; correlation over all of them, up to where the sum
  /// of two neighbouring autocorrelations is no longer seen above chance (after C. J. Geyer 1992).
  static SerialCorrelation of(const Eigen::VectorXd& residuals, const std::vector<Eigen::Index>& starts);

  /// Covariance of the sum over rows of `terms` (a row each), Bartlett's weights falling to zero over three
  /// times the rows (W. K. Newey, K. D. West 1987).
  Eigen::MatrixXd covariance_of_sum(const Eigen::MatrixXd& terms,
                                    const std::vector<Eigen::Index>& starts) const;
};

}  // namespace stepwire::estimation
