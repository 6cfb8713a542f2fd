#pragma once

#include <optional>
#include <vector>

namespace stepwire::statistics {

/// Shapiro and Wilk's test of normality.
struct Normality {
  double w = 1.0;  ///< 1 where the values lie as those of a normal distribution do
  double p = 1.0;  ///< of such a W or a smaller one for normal values
};

/// After Royston: Remark AS R94, A remark on algorithm AS 181: the W-test for normality, Applied Statistics
/// 44 (1995), 547-551. Nothing for fewer than 3 values, for more than 5000, and where all are equal.
std::optional<Normality> shapiro_wilk(std::vector<double> values);

}  // namespace stepwire::statistics
