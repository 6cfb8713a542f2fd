#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire {

/// Adds the columns that a study has beside the recorded signals, for figures and claims:
/// - subject and condition in every recording, as words;
/// - of each trial error, normalised, raw, deviation, length and duration, and in task 1 the circle that it
/// is
///   held against, circle.x, circle.y and circle.radius, in a recording behind the file's;
/// - of the experiment mean.CONDITION, p.FACTOR (feedbacks alone) and p_subject.FACTOR (with the subject as a
///   factor), deviation.CONDITION, and of the thesis thesis.CONDITION, in the one behind that.
/// Throws Error where a recorded signal has one of these names.
void add_study_names(const StudyRequest& request, SymbolTable& names);

/// mean.CONDITION, p.FACTOR and p_subject.FACTOR.
std::vector<std::string> outcome_columns(const StudyRequest& request);

/// What of a study has a value for each experiment, by the names of its columns.
std::vector<NamedValue> outcome(const Experiment& experiment, const StudyRequest& request);

/// The recordings of a job's experiments, in the order of the names: the file's, pooled over the trials; the
/// errors; the outcome, of which each experiment is one row. With a sweep each has the swept parameters.
std::vector<Recording> study_recordings(const Experiments& experiments, const StudyRequest& request,
                                        const Job& job);

}  // namespace stepwire
