#include "engine/study/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/statistics/statistics_error.hpp"
#include "engine/study/signal_map.hpp"

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
bool take(std::vector<TrialRun> runs, const StudyRequest& request, Experiment& experiment) {
  for (TrialRun& run : runs) {
    if (run.result.interrupted) return false;
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
TrialRuns::Circles circles_of(const std::vector<TrialRun>& runs, const StudyRequest& request) {
  TrialRuns::Circles circles;
  for (const TrialRun& run : runs) {
    try {
      circles[run.subject] = fit_circle(trial_of(run, request).points);
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

}  // namespace

Experiment perform(TrialRuns& runs, const StudyRequest& request, const Diagram& diagram, std::uint64_t seed,
                   const std::function<void()>& told) {
  Experiment experiment;
  experiment.seed = seed;
  experiment.interrupted = true;
  std::vector<std::size_t> conditions, subjects = request.subjects;
  for (std::size_t i = 0; i < request.conditions.size(); ++i) conditions.push_back(i);
  TrialRuns::Circles circles;
  if (request.circle) {
    const std::size_t first = index_of(request, request.circle->of);
    if (!take(runs.run(seed, subjects, {first}, {}, told), request, experiment)) return experiment;
    circles = circles_of(experiment.runs, request);
    std::erase(conditions, first);
    std::erase_if(subjects, [&](std::size_t subject) { return !circles.contains(subject); });
  }
  if (!take(runs.run(seed, subjects, conditions, circles, told), request, experiment)) return experiment;
  std::stable_sort(experiment.runs.begin(), experiment.runs.end(), [](const TrialRun& a, const TrialRun& b) {
    return std::pair(a.subject, a.condition) < std::pair(b.subject, b.condition);
  });
  for (const TrialRun& run : experiment.runs) experiment.trials.push_back(trial_of(run, request));
  if (experiment.trials.empty()) refuse(request, "no trial was done within the time that 'stop' leaves");
  experiment.interrupted = false;
  score(request, diagram, experiment);
  return experiment;
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
