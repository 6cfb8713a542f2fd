#pragma once

#include <optional>
#include <vector>

namespace stepwire::statistics {

/// A one-way analysis of how far values lie from the middle of their group.
struct VarianceTest {
  double f = 0.0;                   ///< of the distances from the middle
  double above = 0.0, below = 0.0;  ///< degrees of freedom
  double p = 1.0;                   ///< of such an F or a larger one where all variances are equal
};

/// What the distances are taken from: the mean (Levene 1960) or the median (Brown and Forsythe 1974), which
/// stands skewed values better.
enum class Middle { mean, median };

/// Whether groups differ in their variance; groups of fewer than two values are left out. Nothing where fewer
/// than two remain, or in none the distances vary beyond rounding, as with two values in each.
std::optional<VarianceTest> variance_test(const std::vector<std::vector<double>>& groups,
                                          Middle middle = Middle::median);

}  // namespace stepwire::statistics
