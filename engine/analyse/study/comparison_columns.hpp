#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Names of what claims read of conditions within subjects, of every pair A, B of the request's conditions in
/// their order: difference.A_B, low.A_B, high.A_B, p_pair.A_B, holm.A_B, signed_rank.A_B, d.A_B and
/// needed.A_B. A name that two pairs would have belongs to neither.
std::vector<std::string> comparison_columns(const StudyRequest& request);

/// Their values, in the same order; nan for what does not exist.
std::vector<NamedValue> comparison_values(const Experiment& experiment, const StudyRequest& request);

}  // namespace stepwire::study
