#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/study/section_keys.hpp"
#include "engine/analyse/study/study_request.hpp"

namespace stepwire {

namespace {

using Keys = std::vector<std::string>;

const Keys study_keys{"like",   "task",     "subjects", "seed",     "sets",  "conditions",
                      "circle", "position", "way_back", "attempts", "trials"};
const Keys feedback_names{"haptic", "visual", "guiding_path"};

constexpr std::size_t most_subjects = 1000;

/// "haptic" of "task.haptic".
std::string last_name(const std::string& name) {
  return name.substr(name.rfind('.') + 1);
}

/// 1 to count.
std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = i + 1;
  return numbers;
}

/// Reads the keys of one section; each has the file in which it stands.
class Reader {
 public:
  Reader(const Node& node, const Names& names, const Diagram& diagram, Loader& loader, Faults& faults)
      : names_(names),
        diagram_(diagram),
        keys_("study", node, names.file, study_keys, loader, faults),
        runs_(!keys_.find("trials")) {
    request_.place = {names.file, node.mark};
  }

  StudyRequest read(const StudyWords& words) {
    read_task();
    read_subjects();
    request_.seed = keys_.whole("seed", 0, 1'000'000'000, request_.seed);
    request_.attempts = keys_.whole("attempts", 1, 1000, request_.attempts);
    read_sets();
    read_conditions();
    read_position();
    if (request_.task == "1") read_circle();
    if (request_.task == "2") read_way_back();
    if (const Key* trials = keys_.find("trials"))
      request_.trials =
          (std::filesystem::path(trials->file).parent_path() / trials->node->text).lexically_normal();
    require_stop();
    if (words.subjects) request_.subjects = first_numbers(*words.subjects);
    if (words.seed) request_.seed = *words.seed;
    if (!words.trials.empty()) request_.trials = words.trials;
    return std::move(request_);
  }

 private:
  using Key = SectionKeys::Key;

  void read_task() {
    const Key* key = keys_.required("task", "1 (drawing a circle) or 2 (returning to the region)");
    if (!key) return;
    request_.task = key->node->text;
    if (request_.task != "1" && request_.task != "2")
      keys_.fault(*key, fmt::format("there is no task '{}'; 1 is drawing a circle, 2 returning to the region",
                                    request_.task));
    for (const auto& [name, task] : {std::pair{"circle", "1"}, std::pair{"way_back", "2"}})
      if (const Key* other = keys_.find(name); other && request_.task != task)
        keys_.fault(*other, other->mark, "",
                    fmt::format("belongs to task {}, and this is task {}", task, request_.task));
  }

  /// A key that trials need which are run; recorded ones do without.
  const Key* wanted(const std::string& name, const std::string& form) {
    return runs_ ? keys_.required(name, form) : keys_.find(name);
  }

  void read_subjects() {
    const Key* key = wanted("subjects", "10, or a list such as [3, 7]");
    if (!key) return;
    const std::string wrong = fmt::format(
        "'{}' is no whole number from 1 to {}; subjects are how many, or a list of different numbers", "{}",
        most_subjects);
    if (!key->node->is_list()) {
      const auto count = SectionKeys::whole(*key->node, 1, most_subjects);
      if (!count) return keys_.fault(*key, fmt::format(fmt::runtime(wrong), key->node->text));
      request_.subjects = first_numbers(*count);
      return;
    }
    for (const Node& item : key->node->items) {
      const auto number = SectionKeys::whole(item, 1, most_subjects);
      const auto& all = request_.subjects;
      if (!number || std::find(all.begin(), all.end(), *number) != all.end())
        keys_.fault(*key, item.mark, "", fmt::format(fmt::runtime(wrong), item.text));
      else
        request_.subjects.push_back(*number);
    }
    if (key->node->items.empty()) keys_.fault(*key, "the list is empty");
  }

  const DiagramParameter* parameter(const std::string& name) const {
    const auto& all = diagram_.parameters;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
  }

  /// The name of a parameter that is one number.
  std::string parameter_name(const Key& key, const std::string& below, const Mark& mark,
                             const std::string& name) {
    const DiagramParameter* found = parameter(name);
    if (found && std::holds_alternative<double>(found->value.content)) return name;
    Keys all;
    for (const DiagramParameter& one : diagram_.parameters)
      if (std::holds_alternative<double>(one.value.content)) all.push_back(one.name);
    keys_.fault(
        key, mark, below,
        found ? fmt::format("'{}' is no single number", name)
              : fmt::format("there is no parameter '{}'{}", name, nearest_or_all(name, all, "there are")));
    return name;
  }

  /// The parameters that a map hands its named values to, one for each of `wanted`.
  Keys targets(const Key& key, const Node& map, const std::string& below, const Keys& wanted) {
    Keys result(wanted.size());
    if (!map.is_map()) {
      keys_.fault(key, map.mark, below,
                  fmt::format("says which parameter takes what: {{{0}: {0}, ..}}", wanted[0]));
      return result;
    }
    for (const Entry& entry : map.entries)
      if (std::find(wanted.begin(), wanted.end(), entry.key) == wanted.end())
        keys_.fault(key, entry.mark, below,
                    fmt::format("there is no '{}' here{}", entry.key,
                                nearest_or_all(entry.key, wanted, "there are")));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const Node* node = map.find(wanted[i]);
      const std::string inside = (below.empty() ? "" : below + ".") + wanted[i];
      if (node)
        result[i] = parameter_name(key, inside, node->mark, node->text);
      else
        keys_.fault(key, map.mark, below,
                    fmt::format("'{}' is missing: {}: PARAMETER", wanted[i], wanted[i]));
    }
    return result;
  }

  void read_sets() {
    const Key* key = wanted("sets", "{subject: PARAMETER, seed: PARAMETER}");
    if (!key) return;
    const Keys found = targets(*key, *key->node, "", {"subject", "seed"});
    request_.subject_parameter = found[0];
    request_.seed_parameter = found[1];
  }

  void read_conditions() {
    const Key* key = keys_.required("conditions", "{V: {visual: 1}, HV: {haptic: 1, visual: 1}}");
    if (!key) return;
    if (!key->node->is_map() || key->node->entries.empty())
      return keys_.fault(
          *key, "names the conditions and what each sets: {V: {visual: 1}, HV: {haptic: 1, visual: 1}}");
    for (const Entry& entry : key->node->entries) read_condition(*key, entry);
  }

  void read_condition(const Key& key, const Entry& entry) {
    StudyCondition condition;
    condition.feedback.name = entry.key;
    if (!entry.value.is_map() && entry.value.kind != Node::Kind::empty)
      return keys_.fault(key, entry.value.mark, entry.key, "is a map of what is set: {haptic: 1}, or {}");
    for (const Entry& set : entry.value.entries) {
      const std::string feedback = last_name(set.key);
      if (std::find(feedback_names.begin(), feedback_names.end(), feedback) == feedback_names.end()) {
        keys_.fault(key, set.mark, entry.key,
                    fmt::format("'{}' is no feedback{}; conditions differ by nothing else", set.key,
                                nearest_or_all(feedback, feedback_names, "there are")));
        continue;
      }
      if (runs_) parameter_name(key, entry.key, set.mark, set.key);
      if (set.value.text != "0" && set.value.text != "1")
        keys_.fault(key, set.value.mark, entry.key,
                    fmt::format("{}: '{}' is neither 1 (on) nor 0 (off)", set.key, set.value.text));
      const bool on = set.value.text == "1";
      bool FeedbackCondition::*const member = feedback == "haptic"   ? &FeedbackCondition::haptic
                                              : feedback == "visual" ? &FeedbackCondition::visual
                                                                     : &FeedbackCondition::guiding_path;
      condition.feedback.*member = on;
      condition.settings.push_back({set.key, set.value.text, key.file, set.mark});
    }
    request_.conditions.push_back(std::move(condition));
  }

  const RecordedSignal* recorded(const Key& key, const Node& node, const std::string& below,
                                 std::size_t* recording = nullptr) {
    Keys all;
    for (std::size_t r = 0; r < diagram_.records.size(); ++r)
      for (const RecordedSignal& signal : diagram_.records[r].signals) {
        all.push_back(signal.name);
        if (signal.name != node.text) continue;
        if (recording) *recording = r;
        if (names_.find(signal.name + ".2") && !names_.find(signal.name + ".3")) return &signal;
        keys_.fault(key, node.mark, below,
                    fmt::format("'{}' is no point of the plane, which has two elements", node.text));
        return nullptr;
      }
    keys_.fault(
        key, node.mark, below,
        fmt::format("'{}' is not recorded{}", node.text, nearest_or_all(node.text, all, "recorded are")));
    return nullptr;
  }

  void read_position() {
    const Key* key = keys_.required("position", "a recorded signal, the place of the end-effector");
    if (!key) return;
    if (const RecordedSignal* signal = recorded(*key, *key->node, "", &request_.recording)) {
      request_.position = signal->name;
      position_ = signal->signal;
    }
  }

  void read_circle() {
    const Key* key =
        keys_.required("circle", "{of: NO, sets: {x: PARAMETER, y: PARAMETER, radius: PARAMETER}}");
    if (!key) return;
    const Node *of = key->node->find("of"), *sets = key->node->find("sets");
    if (!of || (!sets && runs_))
      return keys_.fault(*key,
                         "is written {of: CONDITION, sets: {x: PARAMETER, y: PARAMETER, radius: PARAMETER}}");
    const Keys all = request_.condition_names();
    if (std::find(all.begin(), all.end(), of->text) == all.end())
      keys_.fault(
          *key, of->mark, "of",
          fmt::format("there is no condition '{}'{}", of->text, nearest_or_all(of->text, all, "there are")));
    const Keys found = sets ? targets(*key, *sets, "sets", {"x", "y", "radius"}) : Keys(3);
    request_.circle = CircleHandover{of->text, found[0], found[1], found[2]};
  }

  void read_way_back() {
    const Key* key =
        keys_.required("way_back", "a recorded signal, the direction of the way back at a place");
    if (!key) return;
    const Node& node = *key->node;
    const Node* direction = node.is_map() ? node.find("direction") : &node;
    const Node* position = node.find("position");
    if (!direction)
      return keys_.fault(
          *key, "is a recorded signal, or {direction: SIGNAL, position: SIGNAL that it follows from}");
    const RecordedSignal* to = recorded(*key, *direction, "direction");
    const RecordedSignal* from = position ? recorded(*key, *position, "position") : nullptr;
    if (to)
      request_.way_back =
          WayBackSignals{from ? from->signal : position_, to->signal, {key->file, direction->mark}};
  }

  void require_stop() {
    if (!diagram_.stop_when && runs_)
      keys_.fault(
          "a trial ends by 'stop_when'; one that goes on until 'stop' is repeated. This file has no "
          "'stop_when'");
    if (diagram_.records.empty()) keys_.fault("this file records nothing");
  }

  const Names& names_;
  const Diagram& diagram_;
  SectionKeys keys_;
  bool runs_;  ///< trials are runs of the file, not recorded ones
  SignalRef position_;
  StudyRequest request_;
};

}  // namespace

StudyRequest read_study(const Node& node, const Names& names, const Diagram& diagram, Loader& loader,
                        const StudyWords& words, Faults& faults) {
  const std::size_t before = faults.size();
  StudyRequest request = Reader(node, names, diagram, loader, faults).read(words);
  check_sweep(request, diagram, faults);
  if (!request.trials.empty() && faults.size() == before) read_recorded(request, faults);
  return request;
}

}  // namespace stepwire
