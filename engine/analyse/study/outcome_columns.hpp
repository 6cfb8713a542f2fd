#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// A column of what comes out of an experiment.
struct OutcomeColumn {
  std::string name;
  std::string unit{};
};

/// mean.CONDITION, p.FACTOR, p_subject.FACTOR, effect.FACTOR and deviation.CONDITION.
std::vector<OutcomeColumn> outcome_columns(const StudyRequest& request);

/// What came out of an experiment, by the names of these columns.
std::vector<NamedValue> outcome(const Experiment& experiment, const StudyRequest& request);
/// That of an experiment and of those with other people behind it.
std::vector<ExperimentOutcome> outcomes(const Experiment& experiment, const StudyRequest& request);

}  // namespace stepwire::study
