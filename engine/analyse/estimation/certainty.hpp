#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/serial_correlation.hpp"

namespace stepwire::estimation {

/// How the rows of the residuals follow each other, and by which standard errors intervals are made.
struct RowOrder {
  std::vector<Eigen::Index> starts;  ///< rows at which stretches begin whose rows follow each other
  bool in_time = true;               ///< the rows of a stretch are a time series
  StandardErrors use = StandardErrors::serial;
};

/// How sure the unknowns of a fit are, from the derivatives of its residuals. For independent residuals the
/// covariance is s^2 (J' J)^-1 with s^2 = sum of squares / degrees of freedom (classical). Residuals of a
/// time series may go together over some rows; it is (J' J)^-1 S (J' J)^-1 then, with S that of the sum J' r
/// (serial). Where they do not go together both are the same.
struct Certainty {
  Eigen::VectorXd standard_errors;  ///< those that are used; nan of what is not known.
  Eigen::VectorXd classical;        ///< Errors of independent rows.
  Eigen::VectorXd of_series;        ///< Serial errors; without values for rows that are not a series.
  Eigen::VectorXd half_widths;      ///< Of the 95 % interval by Student's t.
  Eigen::MatrixXd covariance;       ///< Of what is known; free directions count as fixed.
  Eigen::MatrixXd correlation;      ///< Nan where one of both is not known.
  double deviation = 0.0;           ///< s, of a weighted residual.
  double quantile = 0.0;            ///< Of Student's t for 95 %, by the worth of the rows.
  SerialCorrelation serial;         ///< Of the residuals in the order of the rows.
  std::vector<Eigen::VectorXd> free_directions;  ///< relative changes of the unknowns that change nothing
};

/// `sizes` are what relative changes of the unknowns are relative to, not 0: their values as a rule;
/// `freedom` are the degrees of freedom, above 0.
Certainty certainty_of(const Eigen::VectorXd& residuals,
                       const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& jacobian,
                       const Eigen::VectorXd& sizes, double freedom, const RowOrder& order);

/// The cure where a search has ended far from the minimum.
inline constexpr const char* elsewhere = "try other starts ('starts: 8') or bounds";

/// A direction in words: "only the product of A and alpha can be known; fix one of them". With `known_before`
/// the start has no such direction: the search has left the region where its unknowns matter.
std::string in_words(const Eigen::VectorXd& direction, const std::vector<std::string>& names,
                     bool known_before = false);

}  // namespace stepwire::estimation
