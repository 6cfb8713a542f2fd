#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/study/analysis.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/study/trial_runs.hpp"

namespace stepwire {

/// One human-subject experiment: all trials of all subjects, simulated or recorded, and what they say.
struct Experiment {
  std::uint64_t seed = 0;
  std::vector<Setting> sets;           ///< values of the point of the file's sweep; empty without one
  std::shared_ptr<PlanFamily> family;  ///< of the runs
  std::vector<TrialRun> runs;          ///< of the trials, in their order; empty where they were recorded
  std::vector<Trial> trials;           ///< by subject, conditions in the order of the request
  PathErrors errors;                   ///< one row for each trial, in their order
  std::optional<TaskAnalysis> analysis;
  std::string not_analysed;          ///< why there is none
  std::vector<std::string> remarks;  ///< trials that were repeated, left out, or took too long
  std::int64_t ticks = 0, compiled_ticks = 0;
};

/// One for each point of a file's sweep, with the same people and noises; one without a sweep.
using Experiments = std::vector<Experiment>;

/// Performs those that a job asks for: the condition to which a circle is fitted first, where there is one,
/// then the others. A trial that is not done in any attempt is left out, and with a first one all trials of
/// that subject. None where the user interrupted. Throws Error.
Experiments perform(TrialRuns& runs, const StudyRequest& request, const Job& job, std::uint64_t seed,
                    const std::function<void()>& told = {});

/// Scores trials that were recorded. Throws Error.
Experiment score_recorded(const StudyRequest& request, const Diagram& diagram);

/// The order in which a subject does the trials, as indices of conditions: that to which a circle is fitted
/// first, the others as drawn for this subject.
std::vector<std::size_t> order_of_conditions(const StudyRequest& request, std::uint64_t seed,
                                             std::size_t subject);

}  // namespace stepwire
