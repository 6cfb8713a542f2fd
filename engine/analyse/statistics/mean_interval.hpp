#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// 95 % confidence intervals of the mean of a condition.
struct MeanInterval {
  double mean = 0.0;
  ConfidenceInterval plain;  ///< Student's interval of the raw values.
  /// Within-subject interval: between-subject variance removed (Cousineau 2005), with Morey's (2008)
  /// correction for the number of conditions. Intervals of two conditions that do not overlap indicate a
  /// difference. Nan for a single condition.
  ConfidenceInterval within_subject;
};

/// Computes the intervals of each column of values[subject][condition]; needs two subjects or more.
std::vector<MeanInterval> mean_intervals(const Eigen::MatrixXd& values);

}  // namespace stepwire::statistics
