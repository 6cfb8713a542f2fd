#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"

namespace stepwire::estimation {

/// Combinations of the unknowns that a Jacobian determines, with its columns scaled to length 1.
struct Resolution {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::VectorXd lengths;            ///< Lengths of the columns.
  Eigen::MatrixXd scaled;             ///< The Jacobian divided by these lengths.
  Eigen::MatrixXd inverse;            ///< Inverse of the scaled J' J, without the free directions.
  Eigen::VectorXd unknown;            ///< Largest component of each unknown in a free direction.
  std::vector<Eigen::VectorXd> free;  ///< Directions of the scaled unknowns that change no residual.

  static Resolution of(const RowMajor& jacobian);
};

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

/// Order of the rows of the residuals, and the kind of standard errors for intervals.
struct RowOrder {
  std::vector<Eigen::Index> starts;  ///< First row of each segment of consecutive rows.
  bool in_time = true;               ///< True: the rows of a segment are a time series.
  StandardErrors use = StandardErrors::serial;
};

/// Uncertainty of the unknowns of a fit, from the derivatives J of its residuals r. For independent residuals
/// the covariance is s^2 (J' J)^-1 with s^2 = sum of squares / degrees of freedom (classical). Residuals of a
/// time series can be correlated over several rows. The covariance is then (J' J)^-1 S (J' J)^-1 with S that
/// of the sum J' r (serial). Without correlation both are equal.
struct Certainty {
  Eigen::VectorXd standard_errors;  ///< The chosen ones; nan for undetermined unknowns.
  Eigen::VectorXd classical;        ///< Errors of independent rows.
  Eigen::VectorXd of_series;        ///< Serial errors; empty for rows that are not a series.
  Eigen::VectorXd half_widths;      ///< Half widths of the 95 % intervals by Student's t.
  Eigen::MatrixXd covariance;       ///< Covariance of the unknowns; free directions count as fixed.
  Eigen::MatrixXd correlation;      ///< Nan if one of the two is undetermined.
  double deviation = 0.0;           ///< Standard deviation s of a weighted residual.
  double quantile = 0.0;            ///< Quantile of Student's t for 95 %, by the effective number of rows.
  SerialCorrelation serial;         ///< Correlation of the residuals in the order of the rows.
  std::vector<Eigen::VectorXd> free_directions;  ///< Relative changes of the unknowns without effect.
};

/// Computes the uncertainty. `sizes` are the references of relative changes of the unknowns, not 0, usually
/// their values. `freedom`, above 0, are the degrees of freedom.
Certainty certainty_of(const Eigen::VectorXd& residuals,
                       const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& jacobian,
                       const Eigen::VectorXd& sizes, double freedom, const RowOrder& order);

/// Advice for a search that ended far from the minimum.
inline constexpr const char* elsewhere = "try other starts ('starts: 8') or bounds";

/// Describes a free direction: "only the product of A and alpha can be known; fix one of them". With
/// `known_before` the start has no free direction: the search has left the region where its unknowns have an
/// effect. With the values of the unknowns, a product is told from a sum only where two are not equally
/// large.
std::string in_words(const Eigen::VectorXd& direction, const std::vector<std::string>& names,
                     bool known_before = false, const Eigen::VectorXd& values = {});

}  // namespace stepwire::estimation
