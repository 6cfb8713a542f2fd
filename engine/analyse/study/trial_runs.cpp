// More than 300 lines with its header: trials of a study and of a sweep of studies are planned, varied and
// run by one pool.
#include "engine/analyse/study/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"

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

Diagram diagram_of(const Job& job, std::size_t study) {
  if (job.points.empty()) return job.plan.diagram;
  Executor run(job.plan_of(study));
  job.family->begin(job.points[study].member, job.settings_of(study), run);
  return run.diagram();
}

std::string with_swept(const Job& job, std::size_t study) {
  return job.points.empty() ? "" : " with " + settings_text(job.settings_of(study));
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
    : source_(std::move(source)),
      request_(request),
      job_(job),
      family_(std::make_shared<PlanFamily>(source_.loader, source_.file, source_.settings, job.plan)) {
  if (source_.engine == ExecutionMode::interpreted) return;
  const std::vector<std::size_t> members = find_conditions();
  if (source_.engine == ExecutionMode::automatic) compile_ahead(members);
}

/// One member or more for each condition, so that code that is compiled for the first trials serves all.
std::vector<std::size_t> TrialRuns::find_conditions() {
  std::vector<std::size_t> members;
  for (std::size_t condition = 0; condition < request_.conditions.size(); ++condition) {
    const TrialRun trial{.study = 0, .subject = request_.subjects.front(), .condition = condition};
    members.push_back(family_->find(settings_of(request_.seed, trial, circles_to_come(trial))));
  }
  return members;
}

/// Compiles beside the first trials what they need. They find it by its text.
void TrialRuns::compile_ahead(const std::vector<std::size_t>& members) {
  struct Wanted {
    const Plan* plan;
    std::vector<VariableBlock> variable;
  };
  std::vector<Wanted> wanted;
  for (const std::size_t member : members)
    wanted.push_back({&family_->plan(member), family_->variable(member)});
  try {
    ahead_ = std::jthread([this, wanted](const std::stop_token& stop) {
      for (const Wanted& one : wanted) source_.code->compile(*one.plan, one.variable, stop);
    });
  } catch (const std::system_error&) {  // without a thread for it nothing is compiled ahead
  }
}

/// Circles as the file has them, for a trial that will be given one of its subject's.
TrialRuns::Circles TrialRuns::circles_to_come(const TrialRun& trial) const {
  if (!request_.circle || request_.conditions[trial.condition].feedback.name == request_.circle->of)
    return {};
  const auto number = [&](const std::string& name) {
    return std::get<double>(parameter_of(job_.plan.diagram, name).value.content);
  };
  return {{{trial.study, trial.subject},
           {{number(request_.circle->x), number(request_.circle->y)}, number(request_.circle->radius)}}};
}

std::vector<Setting> TrialRuns::settings_of(std::uint64_t seed, const TrialRun& trial,
                                            const Circles& circles) const {
  const StudyCondition& condition = request_.conditions[trial.condition];
  std::vector<Setting> settings;
  if (!job_.points.empty()) settings = job_.settings_of(trial.study);
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
  trial.point.own = settings_of(seed, trial, circles);
  try {
    trial.point.member = family_->find(trial.point.own);
  } catch (const Error& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      fault.message +=
          fmt::format(" (in the trial of {}{})", name_of(trial, request_), with_swept(job_, trial.study));
    throw Error(std::move(faults));
  }
}

void TrialRuns::note_end(const Executor& run, TrialRun& trial) const {
  const auto& signals = run.plan().diagram.records[request_.recording].signals;
  const auto position = std::find_if(signals.begin(), signals.end(), [&](const RecordedSignal& signal) {
    return signal.name == request_.position;
  });
  const double* point = run.values() + run.plan().slot(position->signal).offset;
  trial.end = run.time();
  trial.end_point = {point[0], point[1]};
}

void TrialRuns::run_all(std::vector<TrialRun*>& trials, const std::function<void()>& told) {
  std::vector<TieredExecution::Member> members;
  for (std::size_t m = 0; m < family_->size(); ++m)
    members.push_back({&family_->plan(m), family_->variable(m)});
  double ticks = 0.0;
  for (const TrialRun* trial : trials) ticks += static_cast<double>(family_->plan(trial->point.member).steps);
  TieredExecution changeover(source_.engine, source_.code, std::move(members), ticks);
  IdleRuns idle(*family_);
  in_parallel(trials.size(), source_.threads, [&](std::size_t i) {
    TrialRun& trial = *trials[i];
    trial.result.interrupted = source_.interrupt && *source_.interrupt;
    if (trial.result.interrupted) return;
    run_one(trial, idle, changeover);
    if (told) told();
  });
}

std::size_t TrialRuns::number_of(const TrialRun& trial) const {
  const auto subject = std::ranges::find(request_.subjects, trial.subject) - request_.subjects.begin();
  const std::size_t person = trial.study * request_.subjects.size() + static_cast<std::size_t>(subject);
  return person * request_.conditions.size() + trial.condition;
}

void TrialRuns::run_one(TrialRun& trial, IdleRuns& idle, TieredExecution& changeover) {
  const std::size_t member = trial.point.member;
  auto run = idle.take(member);
  family_->begin(member, trial.point.own, *run);
  RunRecording recording(run->plan());
  RunOptions options;
  options.interrupt = source_.interrupt;
  options.observers = source_.observers;
  static_cast<RunEnd&>(trial.result) =
      run_simulation(*run, recording.recorders(), options, changeover, member, number_of(trial));
  trial.result.recordings = recording.take();
  note_end(*run, trial);
  const auto& faults = trial.result.faults;
  trial.done = faults.empty() && !trial.result.stopped && trial.result.ticks < run->plan().steps;
  if (!trial.done && !trial.result.interrupted)
    trial.failures.push_back(faults.empty()
                                 ? fmt::format("not done within {:g} s", run->plan().diagram.stop)
                                 : faults.front().fault.subject + ": " + faults.front().fault.message);
  idle.give_back(member, std::move(run));
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
