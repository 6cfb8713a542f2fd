#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// Adds the columns that a study has beside the recorded signals, for figures and claims:
/// - subject and condition in every recording, as words;
/// - of each trial error, normalised, raw, deviation, length and duration, and in task 1 the circle that it
/// is
///   held against, circle.x, circle.y and circle.radius, in a recording behind the file's;
/// - with it order, which of the person's trials it was, and what it began with of what is carried;
/// - of each experiment its number, mean.CONDITION, p.FACTOR (feedbacks alone) and p_subject.FACTOR (with the
///   subject as a factor), effect.FACTOR, deviation.CONDITION, and of the thesis thesis.CONDITION, in the one
///   behind that.
/// Throws Error where a recorded signal has one of these names.
void add_study_names(const StudyRequest& request, const diagram::Diagram& diagram, query::SymbolTable& names);

/// The recordings of a job's experiments, in the order of the names: the file's, pooled over the trials; the
/// errors; the outcomes, of which each experiment is one row. Trials are those of the first experiment. With
/// a sweep each has the swept parameters.
std::vector<record::Recording> study_recordings(const Experiments& experiments, const StudyRequest& request,
                                                const run::Job& job);

}  // namespace stepwire::study
