#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Returns the column names of comparisons within subjects, for claims. Each pair A, B of the request's
/// conditions, in order, has difference.A_B, low.A_B, high.A_B, p_pair.A_B, holm.A_B, signed_rank.A_B, d.A_B
/// and needed.A_B. A name that two pairs would share is left out.
std::vector<std::string> comparison_columns(const StudyRequest& request);

/// Returns the values of these columns, in the same order; missing ones are nan.
std::vector<NamedValue> comparison_values(const Experiment& experiment, const StudyRequest& request);

}  // namespace stepwire::study
