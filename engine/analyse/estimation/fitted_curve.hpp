#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::estimation {

/// A function of the fitted parameters with its 95 % interval, in SI.
struct FittedCurve {
  std::string name;     ///< what it is
  std::string unit{};   ///< in which it is drawn; empty where it is not known
  std::string label{};  ///< of the variable's axis
  std::optional<unit::Dimension> dimension{};
  std::vector<double> at{}, value{}, low{}, high{};
  /// Where the records have the variable; empty where the file does not say or nothing is recorded.
  std::vector<double> data_range{};
};

/// Evaluates a curve at unknowns x of these names, whose uncertainty goes into the interval in straight lines
/// (delta method); `quantile` is that of Student's t.
FittedCurve fitted_curve(const FitCurve& curve, const std::vector<std::string>& names,
                         const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, double quantile);

/// Widens the range of the data by what a run recorded.
void add_data(const FitCurve& curve, std::span<const record::Recording> recordings, FittedCurve& fitted);

}  // namespace stepwire::estimation
