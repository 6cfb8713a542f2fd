#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/estimation/serial_correlation.hpp"

namespace stepwire::estimation {

/// How sure the unknowns of a fit are, from the derivatives of its residuals. Where the residuals are
/// independent the covariance is s^2 (J' J)^-1 with s^2 = sum of squares / degrees of freedom; where they go
/// together over some rows it is (J' J)^-1 S (J' J)^-1 with S that of the sum J' r.
struct Certainty {
  Eigen::VectorXd standard_errors;               ///< nan where the number cannot be known
  Eigen::VectorXd half_widths;                   ///< of the 95 % interval by Student's t
  Eigen::MatrixXd covariance;                    ///< of what is known; free directions count as fixed
  Eigen::MatrixXd correlation;                   ///< nan where one of both cannot be known
  double deviation = 0.0;                        ///< s, of a weighted residual
  double quantile = 0.0;                         ///< of Student's t for 95 %, by what the rows are worth
  SerialCorrelation serial;                      ///< of the residuals
  std::vector<Eigen::VectorXd> free_directions;  ///< relative changes of the unknowns that change nothing
};

/// `sizes` are what relative changes of the unknowns are relative to, not 0: their values as a rule;
/// `freedom` are the degrees of freedom, above 0; `starts` are the rows at which stretches begin whose rows
/// follow each other in time.
Certainty certainty_of(const Eigen::VectorXd& residuals,
                       const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& jacobian,
                       const Eigen::VectorXd& sizes, double freedom, const std::vector<Eigen::Index>& starts);

/// A direction in words: "only the product of A and alpha can be known; fix one of them".
std::string in_words(const Eigen::VectorXd& direction, const std::vector<std::string>& names);

}  // namespace stepwire::estimation
