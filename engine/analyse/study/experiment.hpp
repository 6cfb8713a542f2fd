#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"
#include "engine/analyse/study/person_runs.hpp"
#include "engine/analyse/study/study_request.hpp"

namespace stepwire::study {

/// What came out of one experiment, by the names of the columns that figures and claims read.
struct ExperimentOutcome {
  std::uint64_t seed = 0;
  std::vector<NamedValue> values;
};

/// One human-subject experiment: all trials of all subjects, simulated or recorded, and what they say.
struct Experiment {
  std::uint64_t seed = 0;
  std::vector<diagram::Setting> sets;       ///< values of the point of the file's sweep; empty without one
  std::shared_ptr<run::PlanFamily> family;  ///< of the runs
  std::vector<TrialRun> runs;               ///< of the trials, in their order; empty where they were recorded
  std::vector<Trial> trials;                ///< by subject, conditions in the order of the request
  PathErrors errors;                        ///< one row for each trial, in their order
  std::optional<TaskAnalysis> analysis;
  std::string not_analysed;          ///< why there is none
  std::vector<std::string> remarks;  ///< trials that were repeated, left out, or took too long
  std::int64_t ticks = 0, compiled_ticks = 0, lane_ticks = 0;
  run::LaneReport lanes;  ///< of all trials that were run by the end of this one
  std::vector<ExperimentOutcome> others{};  ///< of other people: what the seeds behind this one gave
};

/// One for each point of a file's sweep, with the same people and noises; one without a sweep.
using Experiments = std::vector<Experiment>;

/// Whoever takes experiments; calls come from any thread.
struct ExperimentSink {
  std::function<void(Experiments experiments)> done;  ///< with all its trials
  std::function<void()> told;                         ///< behind each trial; may be empty
};

/// Performs the experiments of these seeds, at all points of the file's sweep, several persons at a time.
/// Those that the user interrupts are not done. Throws Error.
void perform(TrialRuns& runs, const StudyRequest& request, const run::Job& job,
             const std::vector<std::uint64_t>& seeds, const ExperimentSink& sink);

/// The experiments of a seed, one for each study, out of the trials of all people_of() it. Throws Error.
Experiments experiments_of(std::vector<std::vector<TrialRun>> people, std::uint64_t seed,
                           const std::shared_ptr<run::PlanFamily>& family, const StudyRequest& request,
                           const run::Job& job);

/// Finds the plans of all trials again, one trial after the other: which thread came first to a plan, and what
/// was compiled ahead, does not show in them.
void number_plans(Experiments& experiments, const TrialRuns& runs);

/// Scores trials that were recorded. Throws Error.
Experiment score_recorded(const StudyRequest& request, const diagram::Diagram& diagram);

}  // namespace stepwire::study
