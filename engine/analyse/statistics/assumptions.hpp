#pragma once

#include <optional>
#include <vector>

namespace stepwire::statistics {

/// Shapiro and Wilk's test of normality.
struct Normality {
  double w = 1.0;  ///< 1 for values placed as those of a normal distribution.
  double p = 1.0;  ///< P of W for normal values.
};

/// Computes the test after Royston: Remark AS R94, A remark on algorithm AS 181: the W-test for normality,
/// Applied Statistics 44 (1995), 547-551. Returns std::nullopt for fewer than 3 values, for more than 5000,
/// and for equal values.
std::optional<Normality> shapiro_wilk(std::vector<double> values);

/// One-way analysis of variance of the distances of values from the middle of their group.
struct VarianceTest {
  double f = 0.0;                   ///< F of the distances.
  double above = 0.0, below = 0.0;  ///< Degrees of freedom.
  double p = 1.0;                   ///< P of F under equal variances.
};

/// Middle of a group: the mean (Levene 1960) or the median (Brown and Forsythe 1974). The median is more
/// robust against skewed values.
enum class Middle { mean, median };

/// Tests whether groups differ in variance. Groups of fewer than two values are left out. Returns
/// std::nullopt if fewer than two groups remain, or if within no group the distances vary beyond rounding
/// (e.g. two values each).
std::optional<VarianceTest> variance_test(const std::vector<std::vector<double>>& groups,
                                          Middle middle = Middle::median);

}  // namespace stepwire::statistics
