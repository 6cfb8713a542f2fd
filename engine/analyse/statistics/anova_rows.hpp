#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Returns a sum of squares, or 0 if it is only the rounding error of scores whose squares sum to `all`.
double beyond_rounding(double sum, double all);

/// Returns a line without F.
AnovaRow anova_row(const std::string& name, double freedom, double sum);

/// Sets F, P and partial eta squared of a line against an error term. They remain nan if either has no
/// degrees of freedom or the error does not vary.
void judge(AnovaRow& row, const AnovaRow& error);

/// Adds a warning that names the terms without F because their error does not vary.
void warn_of_missing_f(Anova& result);

/// Set the description of the design, and add a warning if the variances of its cells differ.
void describe_design(Anova& result, const Observations& observations, const std::vector<std::string>& names);
void warn_of_variances(Anova& result, const Observations& observations,
                       const std::vector<std::string>& names);

}  // namespace stepwire::statistics
