#pragma once

#include <vector>

namespace stepwire::statistics {

/// Limits between which something lies with a stated confidence. What does not exist is nan.
struct ConfidenceInterval {
  double low = 0.0, high = 0.0;
};

/// Student's t test of differences between two conditions, one difference for each subject. What does not
/// exist is nan: with fewer than two differences all but the mean, with equal ones t and P.
struct PairedTest {
  double mean = 0.0;            ///< of the differences
  double deviation = 0.0;       ///< standard deviation of the differences
  double freedom = 0.0;         ///< their number less one
  double t = 0.0, p = 0.0;      ///< two-sided
  ConfidenceInterval interval;  ///< of the mean, 95 %
};

PairedTest paired_test(const std::vector<double>& differences);

/// The interval of a mean: `mean` -/+ t(0.975, freedom) times its standard error; nan without freedom.
ConfidenceInterval student_interval(double mean, double standard_error, double freedom);

}  // namespace stepwire::statistics
