#include "engine/app/session/studies.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/study_parts.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

namespace {

study::Experiments make_experiments(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                                    const Monitor& monitor) {
  const study::StudyRequest& request = *model.study;
  if (!request.trials.empty()) return {study::score_recorded(request, model.job.plan.diagram)};
  KeptExperiments kept(model, call.kept);
  const std::vector<std::uint64_t> seeds = kept.missing();
  StudyCall own = call;
  if (call.workers) own.engine = run::ExecutionMode::interpreted;  // the workers run the trials
  StudyParts parts(registry, model, own, seeds.size(), monitor);
  study::Experiments experiments = call.workers ? perform_by(*call.workers, parts, model, seeds, kept)
                                                : perform_here(*parts.runs, model, seeds, kept, monitor);
  study::number_plans(experiments, *parts.runs);
  parts.runs.reset();  // Ends the compilation, which could still report a problem.
  monitor.note_interpreted(parts.code.take_problem());
  return experiments;
}

/// Returns a sweep whose axes identify the trials: the axes of the file, then subject and condition.
diagram::Sweep axes_of(const LoadedModel& model) {
  const study::StudyRequest& request = *model.study;
  diagram::Sweep sweep = model.job.plan.diagram.sweep.value_or(diagram::Sweep{});
  sweep.axes.push_back({"subject", diagram::SweptValues(request.subject_names()), {}});
  sweep.axes.push_back({"condition", diagram::SweptValues(request.condition_names()), {}});
  return sweep;
}

}  // namespace

run::ExecutionMode engine_of(const LoadedModel& model, const StudyCall& call, std::size_t experiments) {
  if (call.engine != run::ExecutionMode::automatic) return call.engine;
  // Cost of an interpreted block per tick [s], and mean duration of a trial as a fraction of `stop`.
  constexpr double per_block = 2e-8, part = 0.25;
  // Durations from which a compilation beside the trials, or before them, is worth its cost [s].
  constexpr double beside = 4.0, ahead = 20.0;
  const plan::Plan& plan = model.job.plan;
  const auto trials =
      static_cast<double>(model.study->subjects.size() * model.study->conditions.size() * experiments);
  const double ticks = static_cast<double>(plan.steps) * part * trials;
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  const double seconds = per_block * static_cast<double>(plan.diagram.blocks.size()) * ticks / cores;
  return seconds > ahead    ? run::ExecutionMode::compiled
         : seconds > beside ? run::ExecutionMode::automatic
                            : run::ExecutionMode::interpreted;
}

study::TrialSource trial_source(diagram::Loader& loader, const LoadedModel& model, run::ExecutionMode engine,
                                plan::CodeSource& code, const Monitor& monitor) {
  study::TrialSource source{loader, model.file,       call_settings(model.options), engine, &code,
                            0,      monitor.interrupt};
  source.observers = monitor.observers;
  return source;
}

std::string study_key(const LoadedModel& model, bool with_seed) {
  const study::StudyRequest& request = *model.study;
  std::string key = fmt::format(
      "{} {} {} {} {} {} {} {} {}", model.hash, request.task, fmt::join(request.subjects, ","),
      with_seed ? fmt::format("{}+{}", request.seed, request.experiments) : "", request.subject_parameter,
      request.seed_parameter, request.position, request.attempts, request.trials);
  for (const study::StudyCondition& condition : request.conditions) {
    key += " " + condition.feedback.name;
    for (const diagram::Setting& setting : condition.settings)
      key += fmt::format(",{}={}", setting.name, setting.value);
  }
  // The hash has the first point of a sweep; a setting that is without effect there may change others.
  key += fmt::format(" set ({})", run::settings_text(call_settings(model.options)));
  for (std::size_t point = 0; point < model.job.points.size(); ++point)
    key += fmt::format(" ({})", run::settings_text(model.job.settings_of(point)));
  for (const std::size_t condition : request.first) key += fmt::format(" first {}", condition);
  for (const std::size_t condition : request.practice) key += fmt::format(" practice {}", condition);
  for (const study::CarriedValue& carried : request.carry)
    key += fmt::format(" {}={}", carried.parameter, carried.signal);
  if (request.circle)
    key += fmt::format(" {} {} {} {}", request.circle->of, request.circle->x, request.circle->y,
                       request.circle->radius);
  if (request.way_back)
    for (const diagram::SignalRef& signal : {request.way_back->position, request.way_back->direction})
      key += fmt::format(" {}.{}", signal.block, signal.output);
  return key;
}

Studies::Shared Studies::experiments(const Registry& registry, const LoadedModel& model,
                                     const StudyCall& call, const Monitor& monitor) {
  std::promise<Shared> promise;
  std::shared_future<Shared> future;
  bool is_new = false;
  {
    const std::lock_guard lock(mutex_);
    const auto [known, added] = known_.try_emplace(study_key(model));
    if (added) known->second = promise.get_future().share();
    is_new = added;
    future = known->second;
  }
  if (is_new) try {
      promise.set_value(
          std::make_shared<const study::Experiments>(make_experiments(registry, model, call, monitor)));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  return future.get();
}

Outcome study_outcome(LoadedModel& model, const study::Experiments& experiments) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  outcome.result.interrupted = experiments.empty();
  if (!experiments.empty()) {
    if (model.job.points.empty())
      study::fill_study_tables(experiments.front(), *model.study, model.tables);
    else
      study::fill_sweep_tables(experiments, *model.study, model.tables);
    outcome.result.recordings = study::study_recordings(experiments, *model.study, model.job);
    model.job.plan.diagram.sweep = axes_of(model);
    model.job.points.clear();
    model.job.family = experiments.front().family;
    model.job.trials = true;
  }
  for (const study::Experiment& experiment : experiments) {
    outcome.result.ticks += experiment.ticks;
    outcome.result.compiled_ticks += experiment.compiled_ticks;
    outcome.result.lane_ticks += experiment.lane_ticks;
    outcome.result.lanes = experiment.lanes;
    for (const study::TrialRun& run : experiment.runs) model.job.points.push_back(run.point);
  }
  judge_claims(model, outcome);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace stepwire::session
