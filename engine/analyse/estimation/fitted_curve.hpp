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
  std::string name;     ///< Label of the function.
  std::string unit{};   ///< Unit of its drawing; empty if unknown.
  std::string label{};  ///< Label of the variable's axis.
  std::optional<unit::Dimension> dimension{};
  std::vector<double> at{}, value{}, low{}, high{};
  /// Range of the variable in the records. Empty if the file has no expression of it, or nothing is recorded.
  std::vector<double> data_range{};
};

/// Evaluates a curve at the unknowns x of these names. The interval is that of the linearised function (delta
/// method); `quantile` is that of Student's t.
FittedCurve fitted_curve(const FitCurve& curve, const std::vector<std::string>& names,
                         const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, double quantile);

/// Extends the range of the data by that of a run's recordings.
void add_data(const FitCurve& curve, std::span<const record::Recording> recordings, FittedCurve& fitted);

}  // namespace stepwire::estimation
