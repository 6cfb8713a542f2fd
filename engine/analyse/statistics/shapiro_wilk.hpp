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

}  // namespace stepwire::statistics
