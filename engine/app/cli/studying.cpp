#include "engine/app/cli/studying.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/progress.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire {

namespace {

Experiments make_experiments(const Registry& registry, const Work& work, const WorkOptions& options,
                             const StudyCall& call) {
  const StudyRequest& request = *work.study;
  if (!request.trials.empty()) return {score_recorded(request, work.job.plan.diagram)};
  const std::size_t studies = study_count(work.job);
  Loader loader(registry, options.limits);
  GeneratedCode code;
  TrialSource source = trial_source(loader, work, options, engine_of(work, call, studies), code);
  source.threads = call.threads;
  std::optional<TrialRuns> runs(std::in_place, std::move(source), request, work.job);
  if (!call.visible) return perform(*runs, request, work.job, request.seed);
  Progress progress("study " + std::filesystem::path(work.file).filename().string());
  std::atomic<std::size_t> done = 0;
  const auto all = static_cast<double>(studies * request.subjects.size() * request.conditions.size());
  Experiments experiments = perform(*runs, request, work.job, request.seed,
                                    [&] { progress.show(static_cast<double>(++done) / all); });
  runs.reset();  // so that nothing is compiled any more, which may have a problem to tell
  const std::string problem = code.take_problem();
  if (!problem.empty()) complain("interpreted, since {}\n", problem);
  return experiments;
}

/// What tells the trials apart, as the axes of a sweep: those of the file's own come first.
Sweep axes_of(const Work& work) {
  const StudyRequest& request = *work.study;
  Sweep sweep = work.job.plan.diagram.sweep.value_or(Sweep{});
  sweep.axes.push_back({"subject", request.subject_names(), {}, {}});
  sweep.axes.push_back({"condition", request.condition_names(), {}, {}});
  return sweep;
}

}  // namespace

Engine engine_of(const Work& work, const StudyCall& call, std::size_t experiments) {
  if (call.engine != Engine::automatic) return call.engine;
  // What an interpreted block takes per tick, and the part of `stop` that a trial lasts.
  constexpr double per_block = 2e-8, part = 0.25;
  // [s]: from when a compilation is worth a core of its own, and from when it is worth waiting for.
  constexpr double beside = 4.0, ahead = 20.0;
  const Plan& plan = work.job.plan;
  const auto trials =
      static_cast<double>(work.study->subjects.size() * work.study->conditions.size() * experiments);
  const double ticks = static_cast<double>(plan.steps) * part * trials;
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  const double seconds = per_block * static_cast<double>(plan.diagram.blocks.size()) * ticks / cores;
  return seconds > ahead ? Engine::compiled : seconds > beside ? Engine::automatic : Engine::interpreted;
}

TrialSource trial_source(Loader& loader, const Work& work, const WorkOptions& options, Engine engine,
                         CodeSource& code) {
  TrialSource source{loader, work.file, options.settings, engine, &code, 0, &interrupted()};
  if (options.stop) source.settings.push_back({"stop", *options.stop, "--stop " + *options.stop});
  return source;
}

std::string study_key(const Work& work, bool with_seed) {
  const StudyRequest& request = *work.study;
  std::string key =
      fmt::format("{} {} {} {} {} {} {} {} {}", work.hash, request.task, fmt::join(request.subjects, ","),
                  with_seed ? request.seed : 0, request.subject_parameter, request.seed_parameter,
                  request.position, request.attempts, request.trials);
  for (const StudyCondition& condition : request.conditions) {
    key += " " + condition.feedback.name;
    for (const Setting& setting : condition.settings)
      key += fmt::format(",{}={}", setting.name, setting.value);
  }
  for (std::size_t point = 0; point < work.job.points.size(); ++point)
    key += fmt::format(" ({})", settings_text(work.job.settings_of(point)));
  if (request.circle)
    key += fmt::format(" {} {} {} {}", request.circle->of, request.circle->x, request.circle->y,
                       request.circle->radius);
  if (request.way_back)
    for (const SignalRef& signal : {request.way_back->position, request.way_back->direction})
      key += fmt::format(" {}.{}", signal.block, signal.output);
  return key;
}

Studies::Shared Studies::experiments(const Registry& registry, const Work& work, const WorkOptions& options,
                                     const StudyCall& call) {
  std::promise<Shared> promise;
  std::shared_future<Shared> future;
  bool is_new = false;
  {
    const std::lock_guard lock(mutex_);
    const auto [known, added] = known_.try_emplace(study_key(work));
    if (added) known->second = promise.get_future().share();
    is_new = added;
    future = known->second;
  }
  if (is_new) try {
      promise.set_value(std::make_shared<const Experiments>(make_experiments(registry, work, options, call)));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  return future.get();
}

Outcome carry_out_study(Work& work, const Experiments& experiments) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  outcome.result.interrupted = experiments.empty();
  if (!experiments.empty()) {
    if (work.job.points.empty())
      fill_study_tables(experiments.front(), *work.study, work.tables);
    else
      fill_sweep_tables(experiments, *work.study, work.tables);
    outcome.result.recordings = study_recordings(experiments, *work.study, work.job);
    work.job.plan.diagram.sweep = axes_of(work);
    work.job.points.clear();
    work.job.family = experiments.front().family;
    work.job.trials = true;
  }
  for (const Experiment& experiment : experiments) {
    outcome.result.ticks += experiment.ticks;
    outcome.result.compiled_ticks += experiment.compiled_ticks;
    for (const TrialRun& run : experiment.runs) work.job.points.push_back(run.point);
  }
  judge_claims(work, outcome);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace stepwire
