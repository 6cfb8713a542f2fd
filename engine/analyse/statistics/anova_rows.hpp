#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// A sum of squares; 0 where it is the rounding of scores whose squares sum to `all`.
double beyond_rounding(double sum, double all);

/// A line without F.
AnovaRow anova_row(const std::string& name, double freedom, double sum);

/// Sets F, P and partial eta squared of a line against an error; they stay nan where one of them has no
/// degrees of freedom or the error does not vary.
void judge(AnovaRow& row, const AnovaRow& error);

/// Names the terms without F because their error does not vary.
void warn_of_missing_f(Anova& result);

/// Sets the words on the design, and warns where the variances of its cells differ.
void describe_design(Anova& result, const Observations& observations, const std::vector<std::string>& names);
void warn_of_variances(Anova& result, const Observations& observations,
                       const std::vector<std::string>& names);

}  // namespace stepwire::statistics
