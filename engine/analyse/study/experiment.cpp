#include "engine/analyse/study/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/study/signal_map.hpp"

namespace stepwire::study {

namespace {

[[noreturn]] void refuse(const StudyRequest& request, const std::string& message) {
  throw yaml::Error(yaml::Fault{request.place, "study", message, {}});
}

/// Adds a remark on a repeated or failed trial, with the first of its reasons.
void remark(const TrialRun& run, const StudyRequest& request, Experiment& experiment) {
  if (run.failures.empty()) return;
  experiment.remarks.push_back(
      fmt::format("{}: {}; {}", name_of(run, request), run.failures.front(),
                  run.done ? fmt::format("done in attempt {}", run.attempts)
                           : fmt::format("nor in any other of {} attempts; left out", run.attempts)));
}

/// Moves the scored runs of a person into the experiment.
void take(std::vector<TrialRun> runs, const StudyRequest& request, Experiment& experiment) {
  for (TrialRun& run : runs) {
    remark(run, request, experiment);
    experiment.ticks += run.result.ticks;
    experiment.compiled_ticks += run.result.compiled_ticks;
    experiment.lane_ticks += run.result.lane_ticks;
    if (run.done && run.practice == 0) experiment.runs.push_back(std::move(run));
  }
}

PathErrors errors_of(const std::vector<Trial>& trials, const StudyRequest& request,
                     const diagram::Diagram& diagram) {
  if (request.circle)
    return circle_errors(trials,
                         {.task = request.task, .of = request.circle->of, .time_limit = diagram.stop});
  const ReturnTask task{.task = request.task, .time_limit = diagram.stop};
  const SignalMap way_back(diagram, request.way_back->position, request.way_back->direction,
                           request.way_back->place);
  return return_errors(
      trials, [&](const Eigen::Vector2d& point) { return way_back(point); }, task);
}

void score(const StudyRequest& request, const diagram::Diagram& diagram, Experiment& experiment) {
  try {
    experiment.errors = errors_of(experiment.trials, request, diagram);
  } catch (const statistics::StatisticsError& error) {
    refuse(request, error.what());
  }
  for (const std::string& warning : experiment.errors.warnings) experiment.remarks.push_back(warning);
  try {
    experiment.analysis = analyse(experiment.errors, request.factored());
  } catch (const statistics::StatisticsError& error) {
    experiment.not_analysed = error.what();
  }
}

/// Completes the experiment of one study, whose runs are done.
void finish(const StudyRequest& request, const run::Job& job, std::size_t study, Experiment& experiment) {
  if (!job.points.empty()) experiment.sets = job.settings_of(study);
  std::ranges::stable_sort(experiment.runs, {},
                           [](const TrialRun& run) { return std::pair(run.subject, run.condition); });
  for (const TrialRun& run : experiment.runs) experiment.trials.push_back(trial_of(run, request));
  if (experiment.trials.empty())
    refuse(request,
           fmt::format("no trial was done within the time that 'stop' leaves{}", with_swept(job, study)));
  score(request, diagram_of(job, study), experiment);
}

/// An unfinished experiment at all points of the sweep.
struct OpenExperiment {
  std::vector<std::vector<TrialRun>> people;  ///< Runs of all subjects of each study.
  std::atomic<std::size_t> left = 0;
  std::atomic<bool> interrupted = false;
};

/// Experiments whose persons run in parallel, independently of each other.
class OpenExperiments {
 public:
  OpenExperiments(TrialRuns& runs, const StudyRequest& request, const run::Job& job,
                  const std::vector<std::uint64_t>& seeds, const ExperimentSink& sink)
      : runs_(runs), request_(request), job_(job), seeds_(seeds), sink_(sink), open_(seeds.size()) {
    for (OpenExperiment& one : open_) {
      one.people.resize(people_of(request, job));
      one.left = one.people.size();
    }
  }

  void perform() {
    const std::size_t people = people_of(request_, job_);
    runs_.in_parallel(seeds_.size() * people, [&](std::size_t i) { work(i / people, i % people); });
  }

 private:
  void work(std::size_t which, std::size_t person) {
    OpenExperiment& open = open_[which];
    open.people[person] = run_person(runs_, request_, person_of(request_, seeds_[which], person), sink_.told);
    for (const TrialRun& trial : open.people[person])
      if (trial.result.interrupted) open.interrupted = true;
    if (--open.left > 0 || open.interrupted) return;
    Experiments done = experiments_of(std::move(open.people), seeds_[which], runs_.family(), request_, job_);
    for (Experiment& one : done) one.lanes = runs_.lanes();
    sink_.done(std::move(done));
  }

  TrialRuns& runs_;
  const StudyRequest& request_;
  const run::Job& job_;
  const std::vector<std::uint64_t>& seeds_;
  const ExperimentSink& sink_;
  std::vector<OpenExperiment> open_;
};

}  // namespace

Experiments experiments_of(std::vector<std::vector<TrialRun>> people, std::uint64_t seed,
                           const std::shared_ptr<run::PlanFamily>& family, const StudyRequest& request,
                           const run::Job& job) {
  Experiments experiments(study_count(job));
  for (std::size_t person = 0; person < people.size(); ++person)
    take(std::move(people[person]), request, experiments[person / request.subjects.size()]);
  for (std::size_t study = 0; study < experiments.size(); ++study) {
    experiments[study].seed = seed;
    experiments[study].family = family;
    finish(request, job, study, experiments[study]);
  }
  return experiments;
}

void perform(TrialRuns& runs, const StudyRequest& request, const run::Job& job,
             const std::vector<std::uint64_t>& seeds, const ExperimentSink& sink) {
  OpenExperiments(runs, request, job, seeds, sink).perform();
}

void number_plans(Experiments& experiments, const TrialRuns& runs) {
  std::vector<TrialRun*> trials;
  for (Experiment& experiment : experiments)
    for (TrialRun& trial : experiment.runs) trials.push_back(&trial);
  const std::shared_ptr<run::PlanFamily> family = runs.new_family();
  const std::vector<std::size_t> members = family->find_all(
      trials.size(), [&](std::size_t trial) { return trials[trial]->point.own; }, runs.threads());
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i]->point.member = members[i];
  for (Experiment& experiment : experiments) experiment.family = family;
}

Experiment score_recorded(const StudyRequest& request, const diagram::Diagram& diagram) {
  Experiment experiment;
  experiment.trials = request.recorded;
  score(request, diagram, experiment);
  return experiment;
}

}  // namespace stepwire::study
