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

/// Returns, by trial, its number among the person's trials and the values that it received from the trial
/// before. Nan for recorded trials.
std::vector<table::Column> sequence_columns(const Experiment& experiment, const StudyRequest& request,
                                            const diagram::Diagram& diagram);

/// Adds the columns of a study besides the recorded signals, for figures and claims. All recordings have
/// subject and condition, as words.
/// The recording of errors follows those of the file and has a row per trial: error, normalised, raw,
/// deviation, length and duration. In task 1 it also has the circle of the trial: circle.x, circle.y and
/// circle.radius. It ends with the trial's number (order) and the values carried into it.
/// The last recording has a row per experiment: its number, mean.CONDITION, p.FACTOR (feedbacks only),
/// p_subject.FACTOR (with the subject as a factor), effect.FACTOR, deviation.CONDITION and the published
/// published.CONDITION.
/// Throws Error if a recorded signal has one of these names.
void add_study_names(const StudyRequest& request, const diagram::Diagram& diagram, query::SymbolTable& names);

/// Returns the recordings of a job's experiments in the order of the names. These are the file's, pooled over
/// the trials, then the errors, then the results with one row per experiment. Trials are those of the first
/// experiment. With a sweep each recording has the swept parameters.
std::vector<record::Recording> study_recordings(const Experiments& experiments, const StudyRequest& request,
                                                const run::Job& job);

}  // namespace stepwire::study
