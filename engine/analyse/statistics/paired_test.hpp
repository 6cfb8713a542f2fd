#pragma once

#include <vector>

namespace stepwire::statistics {

/// Limits of a confidence interval; nan if undefined.
struct ConfidenceInterval {
  double low = 0.0, high = 0.0;
};

/// Student's t test of the differences between two conditions, one difference per subject. Undefined values
/// are nan: all but the mean for fewer than two differences, t and P for equal ones.
struct PairedTest {
  double mean = 0.0;            ///< Mean of the differences.
  double deviation = 0.0;       ///< Standard deviation of the differences.
  double freedom = 0.0;         ///< Number of differences less one.
  double t = 0.0, p = 0.0;      ///< P is two-sided.
  ConfidenceInterval interval;  ///< 95 % interval of the mean.
};

PairedTest paired_test(const std::vector<double>& differences);

/// Returns the interval of a mean: `mean` -/+ t(0.975, freedom) times its standard error; nan without degrees
/// of freedom.
ConfidenceInterval student_interval(double mean, double standard_error, double freedom);

}  // namespace stepwire::statistics
