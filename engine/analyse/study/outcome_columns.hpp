#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// A column of the results of an experiment.
struct OutcomeColumn {
  std::string name;
  std::string unit{};
};

/// Returns the columns mean.CONDITION, p.FACTOR, p_subject.FACTOR, effect.FACTOR and deviation.CONDITION.
std::vector<OutcomeColumn> outcome_columns(const StudyRequest& request);

/// Returns the results of an experiment under these names.
std::vector<NamedValue> outcome(const Experiment& experiment, const StudyRequest& request);
/// Returns the results of an experiment and of its `others`.
std::vector<ExperimentOutcome> outcomes(const Experiment& experiment, const StudyRequest& request);

}  // namespace stepwire::study
