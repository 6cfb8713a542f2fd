#include "engine/study/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/run/parallel.hpp"
#include "engine/run/pooling.hpp"

namespace stepwire {

namespace {

constexpr std::uint64_t most = 1'000'000'000;
enum Purpose : std::uint64_t { person = 1, noise = 2 };

const DiagramParameter& parameter_of(const Diagram& diagram, const std::string& name) {
  return *std::ranges::find(diagram.parameters, name, &DiagramParameter::name);
}

/// A number in SI as a setting of a parameter.
std::string text_of(const DiagramParameter& parameter, double value) {
  const bool has_unit = parameter.dimension && *parameter.dimension != Dimension{};
  return fmt::format("{}{}", value, has_unit ? " " + si_name(*parameter.dimension) : "");
}

}  // namespace

std::size_t study_count(const Job& job) {
  return std::max<std::size_t>(1, job.points.size());
}

const Diagram& diagram_of(const Job& job, std::size_t study) {
  return job.points.empty() ? job.plan.diagram : job.points[study].plan.diagram;
}

std::string with_swept(const Job& job, std::size_t study) {
  return job.points.empty() ? "" : " with " + settings_text(job.points[study].settings);
}

std::string name_of(const TrialRun& trial, const StudyRequest& request) {
  return fmt::format("subject {}, condition {}", trial.subject,
                     request.conditions[trial.condition].feedback.name);
}

std::uint64_t drawn_number(std::initializer_list<std::uint64_t> from) {
  std::uint64_t hash = 0;
  for (const std::uint64_t number : from) {  // SplitMix64 (Steele, Lea and Flood 2014) of each sum
    hash += number + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return hash % most;
}

TrialRuns::TrialRuns(TrialSource source, const StudyRequest& request, const Job& job)
    : source_(std::move(source)), request_(request), job_(job) {
  if (source_.engine != Engine::interpreted)
    code_ = std::make_unique<TrialCode>(*source_.code, probes(), source_.engine == Engine::automatic);
}

/// Other people, noises and circles under each condition of each study, of the first one twice.
std::vector<Plan> TrialRuns::probes() {
  std::vector<Plan> probes;
  const std::size_t conditions = request_.conditions.size();
  for (std::size_t i = 0; i < conditions * (1 + study_count(job_)); ++i) {
    const std::size_t round = i / conditions;
    add_probe(most + i, {.study = round == 0 ? 0 : round - 1, .subject = i + 1, .condition = i % conditions},
              probes);
  }
  return probes;
}

void TrialRuns::add_probe(std::uint64_t seed, TrialRun probe, std::vector<Plan>& probes) {
  Circles circles;
  const auto number = [&](const std::string& name) {
    return std::get<double>(parameter_of(job_.plan.diagram, name).value.content);
  };
  const double aside = 1e-5 * static_cast<double>(probe.subject);
  if (request_.circle)
    circles[{probe.study, probe.subject}] = {
        {number(request_.circle->x) + aside, number(request_.circle->y) + aside},
        number(request_.circle->radius) + aside};
  try {
    plan(seed, probe, circles);
    probes.push_back(std::move(probe.point.plan));
  } catch (const Error&) {  // a diagram may refuse what no trial will ask of it
  }
}

std::vector<Setting> TrialRuns::settings_of(std::uint64_t seed, const TrialRun& trial,
                                            const Circles& circles) const {
  const StudyCondition& condition = request_.conditions[trial.condition];
  std::vector<Setting> settings;
  if (!job_.points.empty()) settings = job_.points[trial.study].settings;
  settings.insert(settings.end(), condition.settings.begin(), condition.settings.end());
  const auto set = [&](const std::string& parameter, const std::string& value) {
    settings.push_back({parameter, value, request_.place.file, request_.place.mark});
  };
  set(request_.subject_parameter, std::to_string(drawn_number({person, seed, trial.subject})));
  set(request_.seed_parameter,
      std::to_string(drawn_number({noise, seed, trial.subject, trial.condition, trial.attempts})));
  const auto circle = circles.find({trial.study, trial.subject});
  if (!request_.circle || circle == circles.end()) return settings;
  const auto set_length = [&](const std::string& name, double value) {
    set(name, text_of(parameter_of(job_.plan.diagram, name), value));
  };
  set_length(request_.circle->x, circle->second.centre.x());
  set_length(request_.circle->y, circle->second.centre.y());
  set_length(request_.circle->radius, circle->second.radius);
  return settings;
}

void TrialRuns::plan(std::uint64_t seed, TrialRun& trial, const Circles& circles) {
  trial.point.settings = settings_of(seed, trial, circles);
  std::vector<Setting> all = source_.settings;
  all.insert(all.end(), trial.point.settings.begin(), trial.point.settings.end());
  try {
    trial.point.plan = make_plan(source_.loader.load_point(source_.file, all));
  } catch (const Error& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      fault.message +=
          fmt::format(" (in the trial of {}{})", name_of(trial, request_), with_swept(job_, trial.study));
    throw Error(std::move(faults));
  }
}

void TrialRuns::note_end(const Simulation& run, TrialRun& trial) const {
  const auto& signals = run.plan().diagram.records[request_.recording].signals;
  const auto position = std::find_if(signals.begin(), signals.end(), [&](const RecordedSignal& signal) {
    return signal.name == request_.position;
  });
  const double* point = run.values() + run.plan().slot(position->signal).offset;
  trial.end = run.time();
  trial.end_point = {point[0], point[1]};
}

void TrialRuns::run_all(std::vector<TrialRun*>& trials, const std::function<void()>& told) {
  std::vector<const Plan*> plans;
  for (const TrialRun* trial : trials) plans.push_back(&trial->point.plan);
  Changeover changeover(source_.engine, code_.get(), plans);
  in_parallel(trials.size(), source_.threads, [&](std::size_t i) {
    TrialRun& trial = *trials[i];
    RunOptions options;
    options.interrupt = source_.interrupt;
    options.ended = [&](const Simulation& run) { note_end(run, trial); };
    trial.result.interrupted = options.interrupt && *options.interrupt;
    if (trial.result.interrupted) return;
    trial.result = run_plan(trial.point.plan, options, changeover, i);
    const auto& faults = trial.result.faults;
    trial.done = faults.empty() && trial.result.ticks < trial.point.plan.steps;
    if (!trial.done && !trial.result.interrupted)
      trial.failures.push_back(faults.empty()
                                   ? fmt::format("not done within {:g} s", trial.point.plan.diagram.stop)
                                   : faults.front().fault.subject + ": " + faults.front().fault.message);
    if (told) told();
  });
}

std::vector<TrialRun> TrialRuns::run(std::uint64_t seed, std::vector<TrialRun> trials, const Circles& circles,
                                     const std::function<void()>& told) {
  std::vector<TrialRun*> open;
  for (TrialRun& trial : trials) open.push_back(&trial);
  for (std::size_t attempt = 1; !open.empty() && attempt <= request_.attempts; ++attempt) {
    for (TrialRun* trial : open) {
      trial->attempts = attempt;
      plan(seed, *trial, circles);
    }
    run_all(open, attempt == 1 ? told : std::function<void()>{});
    for (const TrialRun* trial : open)
      if (trial->result.interrupted) return trials;
    std::erase_if(open, [](const TrialRun* trial) { return trial->done; });
  }
  return trials;
}

}  // namespace stepwire
