#pragma once

#include <Eigen/Core>
#include <vector>

namespace stepwire::estimation {

/// Correlation of residuals over consecutive rows. Model errors and filtered noise last for many rows, which
/// then count less than their number. An interval that assumes independent rows would be too narrow.
struct SerialCorrelation {
  Eigen::Index rows = 0;   ///< Number of correlated consecutive rows; 0: independent.
  double inflation = 1.0;  ///< Number of rows that are worth one independent row.

  /// Estimates the correlation of residuals in segments that begin at these rows. It sums autocorrelations
  /// until two neighbouring ones are no longer above chance (after C. J. Geyer 1992).
  static SerialCorrelation of(const Eigen::VectorXd& residuals, const std::vector<Eigen::Index>& starts);

  /// Returns the covariance of the sum over the rows of `terms`. Bartlett's weights fall to zero over three
  /// times the correlated rows (W. K. Newey, K. D. West 1987).
  Eigen::MatrixXd covariance_of_sum(const Eigen::MatrixXd& terms,
                                    const std::vector<Eigen::Index>& starts) const;
};

}  // namespace stepwire::estimation
