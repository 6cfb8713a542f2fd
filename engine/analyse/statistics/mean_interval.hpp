#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Between which values the mean of a condition lies, 95 %.
struct MeanInterval {
  double mean = 0.0;
  ConfidenceInterval plain;  ///< Student's, of the values as they are
  /// Without what tells subjects apart as a whole (Cousineau 2005, widened for the number of conditions after
  /// Morey 2008): where these of two conditions lie apart tells of their difference. Nan for one condition.
  ConfidenceInterval within_subject;
};

/// Of each column of values[subject][condition]; two subjects or more.
std::vector<MeanInterval> mean_intervals(const Eigen::MatrixXd& values);

}  // namespace stepwire::statistics
