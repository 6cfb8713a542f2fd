#include "engine/analyse/study/person_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/study/drawn_number.hpp"

namespace stepwire::study {

namespace {

constexpr std::uint64_t order = 3;  // distinguishes these drawn numbers from those of trials

bool is_first_of_circle(std::size_t condition, const StudyRequest& request) {
  return request.circle && request.conditions[condition].feedback.name == request.circle->of;
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
  Trial trial{
      std::to_string(run.subject), request.task, request.conditions[run.condition].feedback.name, {}, {}};
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
