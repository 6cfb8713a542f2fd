#include "engine/analyse/study/study_request.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"

namespace stepwire::study {

void read_recorded(StudyRequest& request, yaml::Faults& faults) {
  request.recorded = read_trials(request.trials);
  std::erase_if(request.recorded, [&](const Trial& trial) { return trial.task != request.task; });
  const std::vector<std::string> conditions = request.condition_names(), subjects = request.subject_names();
  for (const Trial& trial : request.recorded)
    if (std::find(conditions.begin(), conditions.end(), trial.condition) == conditions.end())
      return faults.add({{request.trials, {}},
                         "",
                         fmt::format("subject {}: there is no condition '{}' in the study", trial.subject,
                                     trial.condition) +
                             yaml::nearest_or_all(trial.condition, conditions, "there are"),
                         {}});
  if (request.recorded.empty())
    return faults.add(
        {{request.trials, {}}, "", fmt::format("there are no trials of task {}", request.task), {}});
  const auto place = [](const std::vector<std::string>& all, const std::string& name) {
    return std::find(all.begin(), all.end(), name) - all.begin();
  };
  const auto key = [&](const Trial& trial) {
    return std::pair(place(subjects, trial.subject), place(conditions, trial.condition));
  };
  std::stable_sort(request.recorded.begin(), request.recorded.end(),
                   [&](const Trial& a, const Trial& b) { return key(a) < key(b); });
}

std::vector<std::string> set_for_each_trial(const StudyRequest& request) {
  std::vector<std::string> own{request.subject_parameter, request.seed_parameter};
  for (const StudyCondition& condition : request.conditions)
    for (const diagram::Setting& setting : condition.settings) own.push_back(setting.name);
  return own;
}

std::vector<std::string> varied_by_trials(const StudyRequest& request) {
  std::vector<std::string> all = set_for_each_trial(request);
  if (request.circle) all.insert(all.end(), {request.circle->x, request.circle->y, request.circle->radius});
  for (const CarriedValue& carried : request.carry) all.push_back(carried.parameter);
  std::erase(all, "");
  return all;
}

void check_sweep(const StudyRequest& request, const diagram::Diagram& diagram, yaml::Faults& faults) {
  if (!diagram.sweep || diagram.sweep->axes.empty()) return;
  if (!request.trials.empty())
    faults.add({request.place,
                "study",
                fmt::format("the trials of {} were recorded as they are, and 'sweep' would change nothing; "
                            "analyse them with a file without it",
                            request.trials),
                {}});
  const std::vector<std::string> own = set_for_each_trial(request);
  for (const diagram::Sweep::Axis& axis : diagram.sweep->axes)
    if (std::find(own.begin(), own.end(), axis.parameter) != own.end())
      faults.add({diagram.place(axis.origin),
                  "sweep." + axis.parameter,
                  "the study sets this for each trial; a study is swept over what all of its trials share",
                  {}});
}

std::vector<std::string> StudyRequest::subject_names() const {
  std::vector<std::string> result;
  for (const Trial& trial : recorded)
    if (std::find(result.begin(), result.end(), trial.subject) == result.end())
      result.push_back(trial.subject);
  if (trials.empty())
    for (const std::size_t subject : subjects) result.push_back(std::to_string(subject));
  return result;
}

std::vector<std::string> StudyRequest::condition_names() const {
  std::vector<std::string> result;
  for (const StudyCondition& condition : conditions) result.push_back(condition.name);
  return result;
}

std::vector<Condition> StudyRequest::factored() const {
  return {conditions.begin(), conditions.end()};
}

}  // namespace stepwire::study
