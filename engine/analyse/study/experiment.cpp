#include "engine/analyse/study/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/study/signal_map.hpp"

namespace stepwire {

namespace {

constexpr std::uint64_t order = 3;  // another purpose of drawn numbers than those of trials

[[noreturn]] void refuse(const StudyRequest& request, const std::string& message) {
  throw Error(Fault{request.place, "study", message, {}});
}

/// The path of a run: what it recorded, and where it was done.
Trial trial_of(const TrialRun& run, const StudyRequest& request) {
  Trial trial{
      std::to_string(run.subject), request.task, request.conditions[run.condition].feedback.name, {}, {}};
  const Table& table = run.result.recordings[request.recording].table;
  trial.time = table.find("time")->values;
  trial.points.resize(2, static_cast<Eigen::Index>(trial.time.size()));
  for (const Eigen::Index axis : {0, 1}) {
    const auto& values = table.find(fmt::format("{}.{}", request.position, axis + 1))->values;
    trial.points.row(axis) = Eigen::Map<const Eigen::RowVectorXd>(values.data(), trial.points.cols());
  }
  if (run.end > trial.time.back()) {
    trial.time.push_back(run.end);
    trial.points.conservativeResize(2, trial.points.cols() + 1);
    trial.points.rightCols<1>() = run.end_point;
  }
  return trial;
}

/// Tells what had to be repeated; of each reason the first words are enough.
void remark(const TrialRun& run, const StudyRequest& request, Experiment& experiment) {
  if (run.failures.empty()) return;
  experiment.remarks.push_back(
      fmt::format("{}: {}; {}", name_of(run, request), run.failures.front(),
                  run.done ? fmt::format("done in attempt {}", run.attempts)
                           : fmt::format("nor in any other of {} attempts; left out", run.attempts)));
}

/// Takes the runs that were done; false where the user interrupted.
bool take(std::vector<TrialRun> runs, const StudyRequest& request, Experiments& experiments) {
  for (TrialRun& run : runs) {
    if (run.result.interrupted) return false;
    Experiment& experiment = experiments[run.study];
    remark(run, request, experiment);
    experiment.ticks += run.result.ticks;
    experiment.compiled_ticks += run.result.compiled_ticks;
    if (run.done) experiment.runs.push_back(std::move(run));
  }
  return true;
}

PathErrors errors_of(const std::vector<Trial>& trials, const StudyRequest& request, const Diagram& diagram) {
  if (request.task == "1") {
    CircleTask task;
    task.without_feedback = request.circle->of;
    task.time_limit = diagram.stop;
    return circle_errors(trials, task);
  }
  ReturnTask task;
  task.time_limit = diagram.stop;
  const SignalMap way_back(diagram, request.way_back->position, request.way_back->direction,
                           request.way_back->place);
  return return_errors(
      trials, [&](const Eigen::Vector2d& point) { return way_back(point); }, task);
}

void score(const StudyRequest& request, const Diagram& diagram, Experiment& experiment) {
  try {
    experiment.errors = errors_of(experiment.trials, request, diagram);
  } catch (const StatisticsError& error) {
    refuse(request, error.what());
  }
  for (const std::string& warning : experiment.errors.warnings) experiment.remarks.push_back(warning);
  try {
    experiment.analysis = analyse(experiment.errors, request.feedbacks());
  } catch (const StatisticsError& error) {
    experiment.not_analysed = error.what();
  }
}

/// Circles of all subjects who drew one.
TrialRuns::Circles circles_of(const Experiments& experiments, const StudyRequest& request) {
  TrialRuns::Circles circles;
  for (const Experiment& experiment : experiments)
    for (const TrialRun& run : experiment.runs) {
      try {
        circles[{run.study, run.subject}] = fit_circle(trial_of(run, request).points);
      } catch (const StatisticsError& error) {
        refuse(request, fmt::format("{}: {}", name_of(run, request), error.what()));
      }
    }
  return circles;
}

std::size_t index_of(const StudyRequest& request, const std::string& condition) {
  const auto names = request.condition_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), condition) - names.begin());
}

/// The trials of all studies under some conditions, those of one subject side by side; where circles are
/// drawn, of the subjects who have one.
std::vector<TrialRun> trials_under(const std::vector<std::size_t>& conditions, const StudyRequest& request,
                                   std::size_t studies, const TrialRuns::Circles* circles = nullptr) {
  std::vector<TrialRun> trials;
  for (std::size_t study = 0; study < studies; ++study)
    for (const std::size_t subject : request.subjects)
      for (const std::size_t condition : conditions)
        if (!circles || circles->contains({study, subject}))
          trials.push_back({.study = study, .subject = subject, .condition = condition});
  return trials;
}

/// Runs all trials; false where the user interrupted.
bool run_trials(TrialRuns& runs, const StudyRequest& request, std::uint64_t seed,
                const std::function<void()>& told, Experiments& experiments) {
  std::vector<std::size_t> conditions;
  for (std::size_t i = 0; i < request.conditions.size(); ++i) conditions.push_back(i);
  const auto run = [&](const std::vector<TrialRun>& trials, const TrialRuns::Circles& circles) {
    return take(runs.run(seed, trials, circles, told), request, experiments);
  };
  if (!request.circle) return run(trials_under(conditions, request, experiments.size()), {});
  const std::size_t first = index_of(request, request.circle->of);
  if (!run(trials_under({first}, request, experiments.size()), {})) return false;
  const TrialRuns::Circles circles = circles_of(experiments, request);
  std::erase(conditions, first);
  return run(trials_under(conditions, request, experiments.size(), &circles), circles);
}

}  // namespace

Experiments perform(TrialRuns& runs, const StudyRequest& request, const Job& job, std::uint64_t seed,
                    const std::function<void()>& told) {
  Experiments experiments(study_count(job));
  if (!run_trials(runs, request, seed, told, experiments)) return {};
  for (std::size_t study = 0; study < experiments.size(); ++study) {
    Experiment& experiment = experiments[study];
    experiment.seed = seed;
    experiment.family = runs.family();
    if (!job.points.empty()) experiment.sets = job.settings_of(study);
    std::ranges::stable_sort(experiment.runs, {},
                             [](const TrialRun& run) { return std::pair(run.subject, run.condition); });
    for (const TrialRun& run : experiment.runs) experiment.trials.push_back(trial_of(run, request));
    if (experiment.trials.empty()) {
      refuse(request,
             fmt::format("no trial was done within the time that 'stop' leaves{}", with_swept(job, study)));
    }
    score(request, diagram_of(job, study), experiment);
  }
  return experiments;
}

Experiment score_recorded(const StudyRequest& request, const Diagram& diagram) {
  Experiment experiment;
  experiment.trials = request.recorded;
  score(request, diagram, experiment);
  return experiment;
}

std::vector<std::size_t> order_of_conditions(const StudyRequest& request, std::uint64_t seed,
                                             std::size_t subject) {
  std::vector<std::size_t> result(request.conditions.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = i;
  const auto key = [&](std::size_t condition) {
    const bool first = request.circle && request.conditions[condition].feedback.name == request.circle->of;
    return first ? 0 : 1 + drawn_number({order, seed, subject, condition});
  };
  std::sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return result;
}

}  // namespace stepwire
