#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/study/trial_runs.hpp"

namespace stepwire::study {

/// Results of one experiment, by the names of the columns that figures and claims read.
struct ExperimentOutcome {
  std::uint64_t seed = 0;
  std::vector<NamedValue> values;
};

/// One human-subject experiment: all trials of all subjects, simulated or recorded, and their analysis.
struct Experiment {
  std::uint64_t seed = 0;
  std::vector<diagram::Setting> sets;       ///< Swept values of its point; empty without a sweep.
  std::shared_ptr<run::PlanFamily> family;  ///< Plans of the runs.
  std::vector<TrialRun> runs;               ///< Runs of the trials, in order; empty for recorded ones.
  std::vector<Trial> trials;                ///< By subject, conditions in the order of the request.
  PathErrors errors;                        ///< One row per trial, in order.
  std::optional<TaskAnalysis> analysis;
  std::string not_analysed;          ///< Reason why there is no analysis.
  std::vector<std::string> remarks;  ///< Remarks on trials that were repeated, left out, or too long.
  std::int64_t ticks = 0, compiled_ticks = 0, lane_ticks = 0;
  run::LaneReport lanes;  ///< Lanes of all trials that had run by the end of this experiment.
  std::vector<ExperimentOutcome> others{};  ///< Results of the following seeds, with other people.
};

/// One experiment per point of a file's sweep, with the same people and noises; one without a sweep.
using Experiments = std::vector<Experiment>;

/// Receiver of experiments; called from any thread.
struct ExperimentSink {
  std::function<void(Experiments experiments)> done;  ///< Callback with the experiments of a seed.
  std::function<void()> told;                         ///< Callback after each trial; may be empty.
};

/// Performs the experiments of these seeds at all points of the file's sweep, several persons in parallel.
/// Interrupted ones are not passed to the sink. Throws Error.
void perform(TrialRuns& runs, const StudyRequest& request, const run::Job& job,
             const std::vector<std::uint64_t>& seeds, const ExperimentSink& sink);

/// Assembles the experiments of a seed, one per study, from the trials of all people_of() them. Throws Error.
Experiments experiments_of(std::vector<std::vector<TrialRun>> people, std::uint64_t seed,
                           const std::shared_ptr<run::PlanFamily>& family, const StudyRequest& request,
                           const run::Job& job);

/// Replans all trials in order. The numbering of the plans then depends neither on the order of threads nor
/// on compilation ahead.
void number_plans(Experiments& experiments, const TrialRuns& runs);

/// Scores recorded trials. Throws Error.
Experiment score_recorded(const StudyRequest& request, const diagram::Diagram& diagram);

}  // namespace stepwire::study
