// Reads the keys on the sequence of a person's trials: order, practice, carried values.
#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/study/study_keys.hpp"
#include "engine/model/diagram/named_signals.hpp"

namespace stepwire::study {

using yaml::form;

namespace {

using Texts = std::vector<std::string>;

/// Returns the indices of the conditions in a list.
std::vector<std::size_t> conditions_of(const yaml::Node& node, const StudyRequest& request,
                                       const StudyReading& read) {
  const Texts all = request.condition_names();
  std::vector<std::size_t> found;
  for (const yaml::Node& item : node.as_list()) {
    const auto at = std::ranges::find(all, item.text);
    if (at == all.end())
      read.fault(item.mark, fmt::format("there is no condition '{}'", item.text) +
                                yaml::nearest_or_all(item.text, all, "there are"));
    else
      found.push_back(static_cast<std::size_t>(at - all.begin()));
  }
  return found;
}

void read_order(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  const std::vector<std::size_t> listed = conditions_of(node, request, read);
  for (const std::size_t condition : listed) {
    const std::string& name = request.conditions[condition].name;
    if (std::ranges::count(request.first, condition) > 0)
      read.fault(node.mark, fmt::format("'{}' stands here twice; each condition is done once", name));
    request.first.push_back(condition);
  }
  if (request.circle && !listed.empty() && request.conditions[listed.front()].name != request.circle->of)
    read.fault(node.mark, fmt::format("'{}' comes first, since the circle of the others is fitted to it",
                                      request.circle->of));
}

bool is_set_by_study(const std::string& name, const StudyRequest& request) {
  Texts set{request.subject_parameter, request.seed_parameter};
  if (request.circle) set.insert(set.end(), {request.circle->x, request.circle->y, request.circle->radius});
  for (const StudyCondition& condition : request.conditions)
    for (const diagram::Setting& setting : condition.settings) set.push_back(setting.name);
  return std::ranges::find(set, name) != set.end();
}

bool has_numbers(const diagram::DiagramParameter& parameter) {
  return std::holds_alternative<double>(parameter.value.content) ||
         std::holds_alternative<Eigen::VectorXd>(parameter.value.content);
}

void check_parameter(const yaml::Entry& entry, const StudyRequest& request, const StudyReading& read) {
  Texts names;
  for (const diagram::DiagramParameter& one : read.diagram.parameters)
    if (has_numbers(one)) names.push_back(one.name);
  if (std::ranges::find(names, entry.key) == names.end())
    read.fault(entry.mark, fmt::format("there is no parameter '{}' of numbers", entry.key) +
                               yaml::nearest_or_all(entry.key, names, "there are"));
  else if (is_set_by_study(entry.key, request))
    read.fault(entry.mark, fmt::format("the study sets '{}' for each trial; another parameter takes what is "
                                       "carried",
                                       entry.key));
}

void check_signal(const yaml::Node& node, const StudyReading& read) {
  Texts names;
  for (const auto& [name, signal] : diagram::named_signals(read.diagram)) names.push_back(name);
  if (std::ranges::find(names, node.text) == names.end())
    read.fault(node.mark,
               fmt::format("there is no signal '{}'", node.text) + yaml::did_you_mean(node.text, names));
}

void read_carry(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "is a map of parameters and signals: {memory: learning.y}");
  if (!read.runs) return;
  for (const yaml::Entry& entry : node.entries) {
    check_parameter(entry, request, read);
    check_signal(entry.value, yaml::below(read, entry.key));
    request.carry.push_back({entry.key, entry.value.text, {read.file, entry.value.mark}});
  }
}

std::size_t size_of(const diagram::DiagramParameter& parameter) {
  const auto* list = std::get_if<Eigen::VectorXd>(&parameter.value.content);
  return list ? static_cast<std::size_t>(list->size()) : 1;
}

/// Returns "is in N" or "has no unit".
std::string unit_words(const unit::Dimension& dimension) {
  return dimension == unit::Dimension{} ? "has no unit" : "is in " + unit::si_name(dimension);
}

void check_carried(const CarriedValue& carried, const plan::Plan& plan, yaml::Faults& faults) {
  const auto& parameter =
      *std::ranges::find(plan.diagram.parameters, carried.parameter, &diagram::DiagramParameter::name);
  const diagram::SignalRef signal = diagram::named_signals(plan.diagram).at(carried.signal);
  const auto fault = [&](const std::string& message) {
    faults.add({carried.place, "study.carry." + carried.parameter, message, {}});
  };
  const auto elements = static_cast<std::size_t>(plan.slot(signal).size);
  if (elements != size_of(parameter))
    fault(fmt::format("'{}' has {} element{}, and the parameter {}", carried.signal, elements,
                      elements == 1 ? "" : "s", size_of(parameter)));
  const auto unit = plan.dimension(signal);
  const unit::Dimension own = parameter.dimension.value_or(unit::Dimension{});
  if (unit && *unit != own)
    fault(fmt::format("'{}' {}, but the parameter {}; give that a value {}", carried.signal,
                      unit_words(*unit), unit_words(own),
                      *unit == unit::Dimension{} ? "without a unit" : "in " + unit::si_name(*unit)));
}

}  // namespace

std::vector<StudyRow> sequence_rows() {
  const yaml::Key conditions = form::list(form::string(), 1);
  return {
      {"experiments",
       "how many experiments, each with other people: the seeds from `seed` on. Trials are drawn of the "
       "first; means and significance are those of all",
       form::whole(1, 1'000'000), &StudyRequest::experiments},
      {"attempts", "runs of one trial at most, until one ends by stop_when before stop", form::whole(1, 1000),
       &StudyRequest::attempts},
      {"order",
       "conditions that come first, in this order; the others follow in one that is drawn for each person. "
       "The condition that a circle is fitted to is always the first",
       yaml::like("[NO]", conditions), read_order},
      {"practice", "conditions of trials before the first one, in this order, which are not scored",
       yaml::like("[HV, V]", conditions),
       [](StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
         request.practice = conditions_of(node, request, read);
       }},
      {"carry",
       "what a person takes into the next trial: parameters, and the signals whose last values they get. "
       "The first trial has the file's values",
       yaml::like("{memory: learning.y}",
                  form::naming(yaml::Key::Names::parameter, form::names(form::signal(), 1))),
       read_carry}};
}

void check_carry(const StudyRequest& request, const plan::Plan& plan, yaml::Faults& faults) {
  for (const CarriedValue& carried : request.carry) check_carried(carried, plan, faults);
}

}  // namespace stepwire::study
