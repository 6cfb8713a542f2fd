#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "engine/analyse/study/published.hpp"
#include "engine/analyse/study/study_keys.hpp"
#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::study {

using yaml::form;

namespace {

/// Keys of a section that can inherit from another file (`like`), each with its own file.
class SectionKeys {
 public:
  struct Given {
    std::string name, file;
    yaml::Mark mark;
    const yaml::Node* node;
  };

  /// Collects the keys of `node`, the section `section` of `file`. Then it adds the missing ones from the
  /// file that its key `like` names, and so on. Adds faults for keys that are not in `form`.
  SectionKeys(const std::string& section, const yaml::Node& node, const std::string& file,
              const yaml::Key& form, diagram::Loader& loader, yaml::Faults& faults);

  const Given* find(const std::string& name) const;
  const std::vector<Given>& all() const { return keys_; }

 private:
  void take(const yaml::Node& node, const std::string& file);
  void take_from(const yaml::Node& like, const std::string& file);
  yaml::SectionReading reading(const std::string& file) const;

  std::string section_;
  const yaml::Key& form_;
  diagram::Loader& loader_;
  yaml::Faults& faults_;
  std::set<std::string> files_;
  std::vector<Given> keys_;
};

SectionKeys::SectionKeys(const std::string& section, const yaml::Node& node, const std::string& file,
                         const yaml::Key& form, diagram::Loader& loader, yaml::Faults& faults)
    : section_(section), form_(form), loader_(loader), faults_(faults) {
  take(node, file);
}

yaml::SectionReading SectionKeys::reading(const std::string& file) const {
  return {section_, [file, &faults = faults_](const yaml::Mark& mark, const std::string& subject,
                                              const yaml::Message& message) {
            faults.add({{file, mark}, subject, message, {}});
          }};
}

void SectionKeys::take(const yaml::Node& node, const std::string& file) {
  const yaml::SectionReading read = reading(file);
  if (!files_.insert(file).second)
    return yaml::below(read, "like").fault(node.mark, "this section is like itself in the end");
  if (!node.is_map()) return read.fault(node.mark, "is a map of keys and values");
  read.check_unknown(node, form_);
  for (const yaml::Entry& entry : node.entries)
    if (form_.find(entry.key) && !find(entry.key) && entry.key != "like")
      keys_.push_back({entry.key, file, entry.mark, &entry.value});
  if (const yaml::Node* like = node.find("like")) take_from(*like, file);
}

void SectionKeys::take_from(const yaml::Node& like, const std::string& file) {
  const std::string path =
      (std::filesystem::path(file).parent_path() / like.text).lexically_normal().string();
  const yaml::SectionReading read = yaml::below(reading(file), "like");
  const yaml::Node* section = nullptr;
  try {
    section = loader_.document(path).root.find(section_);
  } catch (const yaml::Error& error) {
    return read.fault(like.mark, error.faults().front().text());
  }
  if (section) return take(*section, path);
  read.fault(like.mark, fmt::format("{} has no section '{}'", path, section_));
}

const SectionKeys::Given* SectionKeys::find(const std::string& name) const {
  const auto found = std::ranges::find(keys_, name, &Given::name);
  return found == keys_.end() ? nullptr : &*found;
}

using ValuesTable = yaml::KeyTable<PublishedValues, StudyReading>;
using PublishedTable = yaml::KeyTable<PublishedStudy, StudyReading>;

void read_values(PublishedValues& published, const yaml::Node& node, const StudyReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "is a map of numbers: {H: 0.217, V: 0.114}");
  const yaml::Key number = form::number();
  for (const yaml::Entry& entry : node.entries)
    if (const auto value = yaml::below(read, entry.key).number(entry.value, number))
      published.values.push_back({entry.key, *value});
}

const ValuesTable& values_table() {
  static const ValuesTable table(
      "what is published", "{source: table 4, values: {haptic: 2e-5, visual: 4e-8}}",
      {yaml::needed(
           ValuesTable::Row{"source", "where it is printed", form::text(), &PublishedValues::source}),
       yaml::needed(
           ValuesTable::Row{"values", "the numbers by name", form::names(form::number(), 1), read_values})});
  return table;
}

PublishedTable::Row values_row(std::string name, std::string doc, PublishedValues PublishedStudy::*values) {
  return {std::move(name), std::move(doc), values_table().form,
          [=](PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
            values_table().read(node, published.*values, read);
          }};
}

void read_examples(PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
  for (const yaml::Node& item : node.as_list())
    values_table().read(item, published.examples.emplace_back(), read);
}

void read_stated_order(PublishedStudy& published, const yaml::Node& node, const StudyReading& read) {
  for (const yaml::Node& item : node.as_list()) {
    if (!item.is_list() || item.items.size() < 2)
      return read.fault(node.mark, "is a list of lists of conditions, the largest error first: [[V, H, HV]]");
    auto& names = published.order.emplace_back();
    for (const yaml::Node& name : item.items) names.push_back(read.text(name));
  }
}

const PublishedTable& published_table() {
  static const PublishedTable table(
      "what is published", "{means: {source: .., values: {..}}}",
      {values_row("means", "normalised errors by condition", &PublishedStudy::means),
       values_row("probabilities", "P of each factor", &PublishedStudy::probabilities),
       {"examples", "normalised errors of single participants", form::one_or_list(values_table().form),
        read_examples},
       {"order", "lists of conditions that the text orders, the largest error first",
        yaml::like("[[V, H, HV]]", form::list(form::list(form::text(), 2))), read_stated_order}});
  return table;
}

/// Returns the schema of `published` in the section `study`.
const yaml::Key& published_form() {
  return published_table().form;
}

/// Reads these keys. Unknown conditions are faults.
void read_published(PublishedStudy& published, const std::vector<std::string>& conditions,
                    const yaml::Node& node, const StudyReading& read) {
  if (!published_table().read(node, published, read)) return;
  const auto require = [&](const std::string& name, const std::string& key) {
    if (std::ranges::find(conditions, name) == conditions.end())
      yaml::below(read, key).fault(node.mark, fmt::format("there is no condition '{}'", name) +
                                                  yaml::nearest_or_all(name, conditions, "there are"));
  };
  for (const NamedValue& mean : published.means.values) require(mean.name, "means");
  for (const PublishedValues& example : published.examples)
    for (const NamedValue& error : example.values) require(error.name, "examples");
  for (const auto& names : published.order)
    for (const std::string& name : names) require(name, "order");
}

using Texts = std::vector<std::string>;

/// Returns the name of a parameter that is a single number; other parameters are faults.
std::string parameter_name(const yaml::Mark& mark, const std::string& name, const StudyReading& read) {
  Texts numbers;
  for (const diagram::DiagramParameter& one : read.diagram.parameters) {
    const bool number = std::holds_alternative<double>(one.value.content);
    if (one.name == name && !number) read.fault(mark, fmt::format("'{}' is no single number", name));
    if (one.name == name) return name;
    if (number) numbers.push_back(one.name);
  }
  read.fault(mark, fmt::format("there is no parameter '{}'", name) +
                       yaml::nearest_or_all(name, numbers, "there are"));
  return name;
}

/// Returns the schema of a map from values to parameters.
yaml::Key targets_form(const Texts& names) {
  std::vector<yaml::Key> keys;
  for (const std::string& name : names)
    keys.push_back(yaml::needed(yaml::key(name, "name of a parameter", form::parameter())));
  return form::keys("it", fmt::format("{{{0}: PARAMETER, ..}}", names.front()), std::move(keys));
}

/// Returns the parameters of such a map, in the order of the keys.
Texts targets(const yaml::Node& map, const yaml::Key& form, const StudyReading& read) {
  Texts result;
  const bool is_map = read.check(map, form);
  for (const yaml::Key& key : form.of) {
    const yaml::Node* node = is_map ? map.find(key.name) : nullptr;
    result.push_back(node ? parameter_name(node->mark, node->text, yaml::below(read, key.name)) : "");
  }
  return result;
}

StudyRow sets_row() {
  const yaml::Key form = targets_form({"subject", "seed"});
  return {"sets", "which parameters take the person and the noise of a trial", form,
          [form](StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
            const Texts found = targets(node, form, read);
            request.subject_parameter = found[0];
            request.seed_parameter = found[1];
          }};
}

/// Returns the factor that a parameter such as task.guiding_path switches: "guiding path".
std::string factor_of(const std::string& parameter) {
  std::string name = parameter.substr(parameter.rfind('.') + 1);
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Refuses a factor that has the name of another parameter's factor or of what each score has.
void check_factor(const StudyRequest& request, const yaml::Entry& set, const StudyReading& read) {
  const std::string factor = factor_of(set.key);
  if (factor == "condition" || factor == "subject")
    return read.fault(set.mark, fmt::format("'{}' is a factor of every study already", factor));
  for (const StudyCondition& condition : request.conditions)
    for (const diagram::Setting& setting : condition.settings)
      if (setting.name != set.key && factor_of(setting.name) == factor)
        return read.fault(set.mark, fmt::format("'{}' gives the factor '{}', as '{}' does; a factor has one "
                                                "parameter",
                                                set.key, factor, setting.name));
}

void read_condition(StudyRequest& request, const yaml::Entry& entry, const StudyReading& read) {
  StudyCondition condition;
  condition.name = entry.key;
  if (!entry.value.is_map() && entry.value.kind != yaml::Node::Kind::empty)
    return read.fault(entry.value.mark, "is a map of what is set: {haptic: 1}, or {}");
  for (const yaml::Entry& set : entry.value.entries) {
    check_factor(request, set, read);
    if (read.runs) parameter_name(set.mark, set.key, read);
    if (set.value.text != "0" && set.value.text != "1")
      read.fault(set.value.mark,
                 fmt::format("{}: '{}' is neither 1 (on) nor 0 (off)", set.key, set.value.text));
    condition.factors.emplace_back(factor_of(set.key), set.value.text == "1");
    condition.settings.push_back({set.key, set.value.text, read.file, set.mark});
  }
  request.conditions.push_back(std::move(condition));
}

void read_conditions(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(
        node.mark, "names the conditions and what each sets: {V: {visual: 1}, HV: {haptic: 1, visual: 1}}");
  for (const yaml::Entry& entry : node.entries) read_condition(request, entry, yaml::below(read, entry.key));
}

/// Returns a recorded signal of two elements; adds a fault and returns nullptr for any other.
const diagram::RecordedSignal* recorded(const yaml::Node& node, const StudyReading& read,
                                        std::size_t* recording = nullptr) {
  Texts all;
  for (std::size_t r = 0; r < read.diagram.records.size(); ++r)
    for (const diagram::RecordedSignal& signal : read.diagram.records[r].signals) {
      all.push_back(signal.name);
      if (signal.name != node.text) continue;
      if (recording) *recording = r;
      if (read.names.find(signal.name + ".2") && !read.names.find(signal.name + ".3")) return &signal;
      read.fault(node.mark, fmt::format("'{}' is no point of the plane, which has two elements", node.text));
      return nullptr;
    }
  read.fault(node.mark, fmt::format("'{}' is not recorded", node.text) +
                            yaml::nearest_or_all(node.text, all, "recorded are"));
  return nullptr;
}

yaml::Key circle_form() {
  return form::keys(
      "it", "{of: CONDITION, sets: {x: PARAMETER, y: PARAMETER, radius: PARAMETER}}",
      {yaml::needed(yaml::key("of", "the condition whose drawing the circle is fitted to", form::string())),
       yaml::key("sets", "which parameters of the other trials take it",
                 targets_form({"x", "y", "radius"}))});
}

void read_circle(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  const yaml::Key form = circle_form();
  if (!read.check(node, form)) return;
  const yaml::Node *of = node.find("of"), *sets = node.find("sets");
  if (!sets && read.runs) read.fault(node.mark, yaml::SectionReading::missing(*form.find("sets")));
  if (!of) return;
  const Texts all = request.condition_names();
  if (std::ranges::find(all, of->text) == all.end())
    yaml::below(read, "of")
        .fault(of->mark, fmt::format("there is no condition '{}'", of->text) +
                             yaml::nearest_or_all(of->text, all, "there are"));
  const Texts found = sets ? targets(*sets, *form.find("sets"), yaml::below(read, "sets")) : Texts(3);
  request.circle = CircleHandover{of->text, found[0], found[1], found[2]};
}

/// Reads the signal of the end-effector's position, the argument of the way back.
void read_position(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  const diagram::RecordedSignal* signal = recorded(node, read, &request.recording);
  if (!signal) return;
  request.position = signal->name;
  request.way_back = WayBackSignals{signal->signal, {}, {}};
}

yaml::Key way_back_form() {
  return form::either(
      {yaml::key("", "the direction of the way back, zero inside the region", form::signal()),
       form::keys("it", "a recorded signal, or {direction: SIGNAL, position: SIGNAL that it follows from}",
                  {yaml::needed(yaml::key("direction", "recorded signal, zero inside", form::signal())),
                   yaml::key("position", "recorded signal that it follows from; that of the study without it",
                             form::signal())})});
}

void read_way_back(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  if (node.is_map() && !read.check(node, way_back_form().of.back())) return;
  const yaml::Node* direction = node.is_map() ? node.find("direction") : &node;
  const yaml::Node* position = node.find("position");
  const auto* to = direction ? recorded(*direction, yaml::below(read, "direction")) : nullptr;
  const auto* from = position ? recorded(*position, yaml::below(read, "position")) : nullptr;
  if (!to) return;
  WayBackSignals way = request.way_back.value_or(WayBackSignals{});
  request.way_back =
      WayBackSignals{from ? from->signal : way.position, to->signal, {read.file, direction->mark}};
}

void read_published_numbers(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  read_published(request.published, request.condition_names(), node, read);
}

void read_trials(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  request.trials = (std::filesystem::path(read.file).parent_path() / node.text).lexically_normal();
}

StudyRow conditions_row() {
  return {
      "conditions", "the factors that each condition switches on (1) or off (0): parameters of this file",
      yaml::like(
          "{V: {visual: 1}, HV: {haptic: 1, visual: 1}}",
          form::names(form::either({form::naming(yaml::Key::Names::parameter, form::names(form::whole(0, 1))),
                                    form::of(yaml::Key::Form::nothing)}),
                      1)),
      read_conditions};
}

std::vector<StudyRow> make_study_rows() {
  std::vector<StudyRow> rows{
      {"like", "file whose section 'study' is taken for what is not given here", form::string()},
      {"task", "name of what people do, in titles and in recorded trials", form::text(), &StudyRequest::task},
      subjects_row(),
      {"seed", "who the people are, and all that is random", form::whole(0, 1'000'000'000),
       &StudyRequest::seed},
      sets_row(),
      conditions_row(),
      {"circle", "people draw a circle: scores are deviations from it", circle_form(), read_circle},
      {"position", "recorded signal of two elements: where the end-effector is", form::signal(),
       read_position},
      {"way_back", "people return to a region: recorded signal, the direction of the way back",
       way_back_form(), read_way_back},
      {"published", "what a source prints of such a study: tables have it beside the study's own numbers",
       published_form(), read_published_numbers},
      {"trials", "CSV file of recorded trials in place of runs: subject, task, condition, time, x, y",
       form::string(), read_trials}};
  std::ranges::move(sequence_rows(), std::back_inserter(rows));
  return rows;
}

const std::vector<StudyRow>& study_rows() {
  static const std::vector<StudyRow> rows = make_study_rows();
  return rows;
}

/// Returns the required keys, of this file or of the one in `like`. Runs need more keys than recorded trials.
Texts needed_keys(bool runs) {
  Texts names{"task", "conditions", "position"};
  if (runs) names.insert(names.end(), {"subjects", "sets"});
  return names;
}

void check_whole(const SectionKeys& keys, const yaml::Mark& mark, const StudyReading& read) {
  for (const std::string& name : needed_keys(read.runs))
    if (!keys.find(name)) read.fault(mark, yaml::SectionReading::missing(*study_form().find(name)));
  if (!keys.find("circle") && !keys.find("way_back"))
    read.fault(mark, "needs 'circle' (people draw one) or 'way_back' (people return): what is scored");
  if (const auto* other = keys.find("way_back"); other && keys.find("circle"))
    yaml::below(read, "way_back")
        .fault(other->mark, "a study is scored by 'circle' or by 'way_back', not both");
  if (!read.diagram.stop_when && read.runs)
    read.fault(mark,
               "a trial ends by 'stop_when'; one that goes on until 'stop' is repeated. This file has no "
               "'stop_when'");
  if (read.diagram.records.empty()) read.fault(mark, "this file records nothing");
}

}  // namespace

const yaml::Key& study_form() {
  static const yaml::Key form = yaml::keys_form("the study", "{task: 1, subjects: 10, ..}", study_rows());
  return form;
}

StudyRequest read_study(const yaml::Node& node, const query::SymbolTable& names,
                        const diagram::Diagram& diagram, diagram::Loader& loader, const StudyWords& words,
                        yaml::Faults& faults) {
  const std::size_t before = faults.size();
  StudyRequest request;
  request.place = {names.file, node.mark};
  const SectionKeys keys("study", node, names.file, study_form(), loader, faults);
  const bool runs = !keys.find("trials");
  for (const StudyRow& row : study_rows())
    if (const auto* given = row.set ? keys.find(row.name) : nullptr)
      row.set(request, *given->node,
              yaml::below(StudyReading(given->file, names, diagram, runs, faults), row.name));
  check_whole(keys, node.mark, StudyReading(names.file, names, diagram, runs, faults));
  if (!keys.find("way_back")) request.way_back.reset();
  if (words.subjects) request.subjects = first_numbers(*words.subjects);
  if (words.seed) request.seed = *words.seed;
  if (words.experiments) request.experiments = *words.experiments;
  if (!words.trials.empty()) request.trials = words.trials;
  if (!request.trials.empty()) request.experiments = 1;
  if (!request.trials.empty() && words.experiments)
    faults.add({request.place, "study", "recorded trials cannot be repeated by the computer", {}});
  check_sweep(request, diagram, faults);
  if (!request.trials.empty() && faults.size() == before) read_recorded(request, faults);
  return request;
}

}  // namespace stepwire::study
