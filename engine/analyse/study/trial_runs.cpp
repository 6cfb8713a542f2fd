#include "engine/analyse/study/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/model/diagram/named_signals.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::study {
namespace {

constexpr std::uint64_t most = 1'000'000'000;

enum Purpose : std::uint64_t { person = 1, noise = 2, noise_of_practice = 4 };  // 3: the order

const diagram::DiagramParameter& parameter_of(const diagram::Diagram& diagram, const std::string& name) {
  return *std::ranges::find(diagram.parameters, name, &diagram::DiagramParameter::name);
}

/// Returns numbers in SI as the text of a parameter's setting.
std::string text_of(const diagram::DiagramParameter& parameter, const std::vector<double>& values) {
  const bool has_unit = parameter.dimension && *parameter.dimension != unit::Dimension{};
  const std::string unit = has_unit ? " " + unit::si_name(*parameter.dimension) : "";
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(fmt::format("{}{}", value, unit));
  const bool list = std::holds_alternative<Eigen::VectorXd>(parameter.value.content);
  return list ? fmt::format("[{}]", fmt::join(texts, ", ")) : texts.front();
}

double moved(double number, double share) {
  return number + share * (number == 0.0 ? 0.1 : std::abs(number));
}

std::vector<double> numbers_of(const Value& value) {
  if (const auto* list = std::get_if<Eigen::VectorXd>(&value.content)) return {list->begin(), list->end()};
  return {std::get<double>(value.content)};
}

constexpr std::uint64_t order = 3;  // distinguishes these drawn numbers from those of trials

bool is_first_of_circle(std::size_t condition, const StudyRequest& request) {
  return request.circle && request.conditions[condition].name == request.circle->of;
}

/// The trials of one person in sequence.
class PersonAtWork {
 public:
  PersonAtWork(TrialRuns& runs, const StudyRequest& request, const Person& person,
               const std::function<void()>& told)
      : runs_(runs), request_(request), person_(person), told_(told) {}

  std::vector<TrialRun> work() {
    bool on = true;
    for (std::size_t i = 0; on && i < request_.practice.size(); ++i)
      on = practise(request_.practice[i], i + 1);
    for (const std::size_t condition : order_of_conditions(request_, person_.seed, person_.subject))
      on = on && count(condition);
    return std::move(trials_);
  }

 private:
  TrialRun trial(std::size_t condition) const {
    return {.seed = person_.seed, .study = person_.study, .subject = person_.subject, .condition = condition};
  }

  /// Runs a trial; false if it was interrupted.
  bool run(TrialRun trial) {
    runs_.run(trial, handed_);
    if (trial.done) handed_.carried = runs_.carried(trial);
    if (!trial.result.interrupted && told_) told_();
    trials_.push_back(std::move(trial));
    return !trials_.back().result.interrupted;
  }

  bool practise(std::size_t condition, std::size_t number) {
    TrialRun one = trial(condition);
    one.practice = number;
    const bool on = run(std::move(one));
    trials_.back().result.recordings.clear();
    return on;
  }

  bool count(std::size_t condition) {
    TrialRun one = trial(condition);
    one.order = ++counted_;
    if (!run(std::move(one))) return false;
    if (!is_first_of_circle(condition, request_)) return true;
    if (trials_.back().done) fit(trials_.back());
    return trials_.back().done;
  }

  void fit(const TrialRun& trial) {
    try {
      handed_.circle = statistics::fit_circle(trial_of(trial, request_).points);
    } catch (const statistics::StatisticsError& error) {
      throw yaml::Error(yaml::Fault{
          request_.place, "study", fmt::format("{}: {}", name_of(trial, request_), error.what()), {}});
    }
  }

  TrialRuns& runs_;
  const StudyRequest& request_;
  const Person& person_;
  const std::function<void()>& told_;
  HandedOver handed_;
  std::size_t counted_ = 0;
  std::vector<TrialRun> trials_;
};

}  // namespace

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

std::size_t study_count(const run::Job& job) {
  return std::max<std::size_t>(1, job.points.size());
}

diagram::Diagram diagram_of(const run::Job& job, std::size_t study) {
  if (job.points.empty()) return job.plan.diagram;
  run::Executor run(job.plan_of(study));
  job.family->begin(job.points[study].member, job.settings_of(study), run);
  return run.diagram();
}

std::string with_swept(const run::Job& job, std::size_t study) {
  return job.points.empty() ? "" : " with " + run::settings_text(job.settings_of(study));
}

std::string name_of(const TrialRun& trial, const StudyRequest& request) {
  return fmt::format("subject {}, condition {}{}", trial.subject, request.conditions[trial.condition].name,
                     trial.practice == 0 ? "" : fmt::format(" (practice {})", trial.practice));
}

TrialRuns::TrialRuns(TrialSource source, const StudyRequest& request, const run::Job& job,
                     std::size_t experiments)
    : source_(std::move(source)), request_(request), job_(job), family_(new_family()) {
  if (source_.engine != run::ExecutionMode::interpreted) find_members();
  if (source_.engine == run::ExecutionMode::automatic) compile_ahead();
  const auto trials = static_cast<double>(study_count(job) * request.subjects.size() * experiments *
                                          (request.conditions.size() + request.practice.size()));
  run::RunOptions options;
  options.interrupt = source_.interrupt;
  options.engine = source_.engine;
  options.code = source_.code;
  options.observers = source_.observers;
  pool_.emplace(*family_, std::move(options), run::PoolWork{trials * static_cast<double>(job.plan.steps)});
}

std::shared_ptr<run::PlanFamily> TrialRuns::new_family() const {
  return std::make_shared<run::PlanFamily>(source_.loader, source_.file, source_.settings, job_.plan);
}

/// Finds the plans of all studies and conditions in advance, so that code compiled for the first trials
/// serves all. Values that trials will pass on are not known yet. They are tried near the file's values, with
/// both signs.
void TrialRuns::find_members() {
  for (std::size_t study = 0; study < study_count(job_); ++study)
    for (std::size_t condition = 0; condition < request_.conditions.size(); ++condition) {
      TrialRun trial{.seed = request_.seed, .study = study, .subject = request_.subjects.front()};
      trial.condition = condition;
      for (const double share : {0.0, 0.01, -0.01}) find_member(trial, file_values(trial, share), share);
      if (!request_.carry.empty() || !request_.practice.empty()) find_member(trial, {}, 0.0);
    }
}

/// Finds the plan of a trial with carried values, and without them, as in the first trial.
void TrialRuns::find_member(TrialRun trial, HandedOver handed, double share) {
  try {
    plan(trial, handed);
    if (handed.carried.empty()) return;
    handed.carried.clear();
    plan(trial, handed);
    handed = {.circle = {}, .carried = file_values(trial, share).carried};  // as in practice
    plan(trial, handed);
  } catch (const yaml::Error&) {
    if (share == 0.0) throw;  // a value near the file's may be refused
  }
}

/// Starts the compilation of these plans in a thread. Trials find the code by its text.
void TrialRuns::compile_ahead() {
  try {
    ahead_ = std::jthread([this, wanted = family_->plans_of_runs()](const std::stop_token& stop) {
      for (const run::PlanOfRuns& one : wanted)
        source_.code->compile(*one.plan, one.differences.variable, {.stop = stop});
    });
  } catch (const std::system_error&) {  // without a thread nothing is compiled ahead
  }
}

/// Returns the values that a trial will receive, moved by a share from those of the file.
HandedOver TrialRuns::file_values(const TrialRun& trial, double share) const {
  HandedOver handed;
  for (const CarriedValue& carried : request_.carry) {
    const diagram::DiagramParameter& parameter = parameter_of(job_.plan.diagram, carried.parameter);
    std::vector<double> numbers = numbers_of(parameter.value);
    for (double& number : numbers) number = moved(number, share);
    handed.carried.push_back(
        {carried.parameter, text_of(parameter, numbers), request_.place.file, request_.place.mark});
  }
  if (!request_.circle || request_.conditions[trial.condition].name == request_.circle->of) return handed;
  const auto number = [&](const std::string& name) {
    return moved(std::get<double>(parameter_of(job_.plan.diagram, name).value.content), share);
  };
  handed.circle = {{number(request_.circle->x), number(request_.circle->y)}, number(request_.circle->radius)};
  return handed;
}

/// Returns the seed of a trial's noise; practice trials have seeds of their own.
std::uint64_t TrialRuns::noise_of(const TrialRun& trial) const {
  if (trial.practice == 0)
    return drawn_number({noise, trial.seed, trial.subject, trial.condition, trial.attempts});
  return drawn_number({noise_of_practice, trial.seed, trial.subject, trial.practice, trial.attempts});
}

std::vector<diagram::Setting> TrialRuns::settings_of(const TrialRun& trial, const HandedOver& handed) const {
  const StudyCondition& condition = request_.conditions[trial.condition];
  std::vector<diagram::Setting> settings;
  if (!job_.points.empty()) settings = job_.settings_of(trial.study);
  settings.insert(settings.end(), condition.settings.begin(), condition.settings.end());
  const auto put = [&](const diagram::Setting& setting) {  // replaces a swept setting
    std::erase_if(settings, [&](const diagram::Setting& one) { return one.name == setting.name; });
    settings.push_back(setting);
  };
  const auto set = [&](const std::string& parameter, const std::string& value) {
    put({parameter, value, request_.place.file, request_.place.mark});
  };
  set(request_.subject_parameter, std::to_string(drawn_number({person, trial.seed, trial.subject})));
  set(request_.seed_parameter, std::to_string(noise_of(trial)));
  std::ranges::for_each(handed.carried, put);
  if (!request_.circle || !handed.circle) return settings;
  const auto set_length = [&](const std::string& name, double value) {
    set(name, text_of(parameter_of(job_.plan.diagram, name), {value}));
  };
  set_length(request_.circle->x, handed.circle->centre.x());
  set_length(request_.circle->y, handed.circle->centre.y());
  set_length(request_.circle->radius, handed.circle->radius);
  return settings;
}

std::vector<diagram::Setting> TrialRuns::carried(const TrialRun& trial) const {
  std::vector<diagram::Setting> settings;
  for (std::size_t i = 0; i < request_.carry.size(); ++i) {
    const CarriedValue& carried = request_.carry[i];
    settings.push_back({carried.parameter,
                        text_of(parameter_of(job_.plan.diagram, carried.parameter), trial.left[i]),
                        carried.place.file, carried.place.mark});
  }
  return settings;
}

void TrialRuns::plan(TrialRun& trial, const HandedOver& handed) {
  trial.point.own = settings_of(trial, handed);
  try {
    trial.point.member = family_->find(trial.point.own);
  } catch (const yaml::Error& error) {
    std::vector<yaml::Fault> faults = error.faults();
    for (yaml::Fault& fault : faults)
      fault.message +=
          fmt::format(" (in the trial of {}{})", name_of(trial, request_), with_swept(job_, trial.study));
    throw yaml::Error(std::move(faults));
  }
}

void TrialRuns::note_end(const run::Executor& run, TrialRun& trial) const {
  const plan::Plan& plan = run.plan();
  const auto numbers = [&](const diagram::SignalRef& signal) {
    const plan::SignalSlot slot = plan.slot(signal);
    const double* first = run.values() + slot.offset;
    return std::vector<double>(first, first + slot.size);
  };
  const auto& signals = plan.diagram.records[request_.recording].signals;
  const auto position = std::ranges::find(signals, request_.position, &diagram::RecordedSignal::name);
  const std::vector<double> point = numbers(position->signal);
  trial.end = run.time();
  trial.end_point = {point[0], point[1]};
  if (request_.carry.empty()) return;
  const auto named = diagram::named_signals(plan.diagram);
  trial.left.clear();
  for (const CarriedValue& carried : request_.carry) trial.left.push_back(numbers(named.at(carried.signal)));
}

CarriedNumbers TrialRuns::begun_with(const run::Executor& run) const {
  CarriedNumbers all;
  const auto& parameters = run.plan().diagram.parameters;
  for (const CarriedValue& carried : request_.carry) {
    const auto parameter = std::ranges::find(parameters, carried.parameter, &diagram::DiagramParameter::name);
    all.push_back(numbers_of(run.parameter(static_cast<std::size_t>(parameter - parameters.begin()))));
  }
  return all;
}

std::size_t TrialRuns::number_of(const TrialRun& trial) const {
  const std::size_t people = request_.subjects.size() * study_count(job_);
  const auto subject = std::ranges::find(request_.subjects, trial.subject) - request_.subjects.begin();
  const std::size_t person = (trial.seed - request_.seed) * people + trial.study * request_.subjects.size() +
                             static_cast<std::size_t>(subject);
  if (trial.practice == 0) return person * request_.conditions.size() + trial.condition;
  const std::size_t counting = request_.experiments * people * request_.conditions.size();
  return counting + person * request_.practice.size() + trial.practice - 1;
}

void TrialRuns::run_once(TrialRun& trial) {
  const run::PooledRun run = pool_->begin(trial.point.member, trial.point.own);
  trial.begun = begun_with(run.simulation());
  trial.result = pool_->run(run, number_of(trial));
  note_end(run.simulation(), trial);
  const auto& faults = trial.result.faults;
  const plan::Plan& plan = run.simulation().plan();
  trial.done = faults.empty() && !trial.result.stopped && trial.result.ticks < plan.steps;
  if (!trial.done && !trial.result.interrupted)
    trial.failures.push_back(faults.empty()
                                 ? fmt::format("not done within {:g} s", plan.diagram.stop)
                                 : faults.front().fault.subject + ": " + faults.front().fault.message.text());
}

void TrialRuns::run(TrialRun& trial, const HandedOver& handed) {
  for (trial.attempts = 1; trial.attempts <= request_.attempts; ++trial.attempts) {
    trial.result.interrupted = interrupted();
    if (trial.result.interrupted) return;
    plan(trial, handed);
    run_once(trial);
    if (trial.done || trial.result.interrupted) return;
  }
  trial.attempts = request_.attempts;
}

std::size_t people_of(const StudyRequest& request, const run::Job& job) {
  return study_count(job) * request.subjects.size();
}

Person person_of(const StudyRequest& request, std::uint64_t seed, std::size_t number) {
  const std::size_t subjects = request.subjects.size();
  return {seed, number / subjects, request.subjects[number % subjects]};
}

std::vector<TrialRun> run_person(TrialRuns& runs, const StudyRequest& request, const Person& person,
                                 const std::function<void()>& told) {
  return PersonAtWork(runs, request, person, told).work();
}

std::vector<std::size_t> order_of_conditions(const StudyRequest& request, std::uint64_t seed,
                                             std::size_t subject) {
  std::vector<std::size_t> result(request.conditions.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = i;
  const auto key = [&](std::size_t condition) -> std::uint64_t {
    const auto listed = std::ranges::find(request.first, condition);
    if (listed != request.first.end()) return static_cast<std::uint64_t>(listed - request.first.begin());
    if (is_first_of_circle(condition, request)) return 0;
    return request.conditions.size() + drawn_number({order, seed, subject, condition});
  };
  std::ranges::sort(result, {}, key);
  return result;
}

Trial trial_of(const TrialRun& run, const StudyRequest& request) {
  Trial trial{std::to_string(run.subject), request.task, request.conditions[run.condition].name, {}, {}};
  const table::Table& table = run.result.recordings[request.recording].table;
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

}  // namespace stepwire::study
