#include "blocks/logic/chart_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/text/count.hpp"
#include "engine/base/text/nearest.hpp"

namespace stepwire {

namespace {

/// True for `name:` without content: a state without output and transitions.
bool is_empty(const Value& tree) {
  return tree.text() && (tree.text()->empty() || *tree.text() == "~");
}

const std::vector<std::string> state_keys{"output", "to",     "timeout", "enter",  "exit",
                                          "each",   "states", "initial", "history"};
const std::vector<std::string> transition_keys{"to", "when", "priority", "set"};

std::vector<std::string> all_names(const std::vector<ChartState>& states) {
  std::vector<std::string> names;
  for (const ChartState& state : states) names.push_back(state.name);
  return names;
}

/// Returns the end of a message: the nearest name, if one is near, and all names behind `what`.
std::string near_or_all(const std::string& word, const std::vector<std::string>& names, std::string what) {
  const std::string near = text::or_nearest(word, names);
  if (!near.empty()) what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  return fmt::format("{} {}: {}", near.empty() ? ";" : near, what, fmt::join(names, ", "));
}

std::string shown(const Value& tree) {
  return tree.text() ? *tree.text() : "this";
}

}  // namespace

ChartReader::ChartReader(const Value& tree, ChartNames names, ChartRefuse refuse)
    : tree_(tree), formulas_(std::move(names), refuse), refuse_(std::move(refuse)) {
  if (!tree_.map() || tree_.map()->empty())
    refuse_("it must be a map of states, as {idle: {to: {push: \"u > 5\"}}, push: {output: [1]}}", tree_);
  gather(tree_, none);
  for (std::size_t s = 0; s < states_.size(); ++s) read_state(s);
  level_outputs();
}

void ChartReader::gather(const Value& map, std::size_t parent) {
  for (const auto& [name, tree] : *map.map()) {
    const std::size_t index = states_.size();
    ChartState state;
    state.name = parent == none ? name : states_[parent].name + "." + name;
    state.parent = parent;
    states_.push_back(std::move(state));
    trees_.push_back(&tree);
    const Value* inner = tree.find("states");
    if (!inner) continue;
    if (!inner->map() || inner->map()->empty())
      refuse_(fmt::format("'states' of state '{}' must be a map of states", states_[index].name), *inner);
    states_[index].initial = index + 1;
    gather(*inner, index);
  }
}

std::size_t ChartReader::find(const std::string& name, std::size_t from) const {
  for (std::size_t holder = from;; holder = states_[holder].parent) {
    const std::string full = holder == none ? name : states_[holder].name + "." + name;
    for (std::size_t s = 0; s < states_.size(); ++s)
      if (states_[s].name == full) return s;
    if (holder == none) return none;
  }
}

std::string ChartReader::names() const {
  return fmt::format("{}", fmt::join(all_names(states_), ", "));
}

std::size_t ChartReader::leaf_of(std::size_t state) const {
  while (states_[state].initial != none) state = states_[state].initial;
  return state;
}

void ChartReader::read_state(std::size_t state) {
  const Value& tree = *trees_[state];
  if (is_empty(tree)) return;
  if (!tree.map())
    refuse_(fmt::format("state '{}' must be a map of output and to", states_[state].name), tree);
  for (const auto& [key, value] : *tree.map()) read_key(state, key, value);
  if (const Value* timeout = tree.find("timeout")) {
    auto last = read_timeouts(state, *timeout);
    std::move(last.begin(), last.end(), std::back_inserter(states_[state].to));
  }
}

void ChartReader::read_key(std::size_t state, const std::string& key, const Value& value) {
  ChartState& made = states_[state];
  const std::string& name = made.name;
  if (key == "output") {
    made.output = read_output(name, value);
  } else if (key == "to") {
    if (!value.map() && !value.list())
      refuse_(fmt::format("'to' of state '{}' must be a map of target: guard", name), value);
    made.to = value.map() ? read_map(state, value) : read_list(state, value);
  } else if (key == "enter") {
    made.enter = formulas_.settings(fmt::format("'enter' of state '{}'", name), value);
  } else if (key == "exit") {
    made.exit = formulas_.settings(fmt::format("'exit' of state '{}'", name), value);
  } else if (key == "each") {
    made.each = formulas_.settings(fmt::format("'each' of state '{}'", name), value);
  } else if (key == "initial") {
    made.initial = initial_of(state);
  } else if (key == "history") {
    read_history(state, value);
  } else if (key != "states" && key != "timeout") {
    refuse_(fmt::format("state '{}' has no '{}'{}", name, key, near_or_all(key, state_keys, "it has")),
            value);
  }
}

void ChartReader::read_history(std::size_t state, const Value& value) {
  ChartState& made = states_[state];
  if (shown(value) != "true" && shown(value) != "false")
    refuse_(fmt::format("'history' of state '{}' must be true or false", made.name), value);
  made.history = shown(value) == "true";
  if (made.initial == none)
    refuse_(fmt::format("state '{}' holds no states that it could remember", made.name), value);
}

std::size_t ChartReader::initial_of(std::size_t state) const {
  const Value& wanted = *trees_[state]->find("initial");
  const std::string full = states_[state].name + "." + shown(wanted);
  for (std::size_t s = 0; s < states_.size(); ++s)
    if (states_[s].name == full && states_[s].parent == state) return s;
  refuse_(fmt::format("state '{}' holds no state '{}' to begin with", states_[state].name, shown(wanted)),
          wanted);
  return none;
}

std::vector<double> ChartReader::read_output(const std::string& name, const Value& tree) const {
  if (tree.text()) return {formulas_.number(name, tree)};
  if (!tree.list() || tree.list()->empty())
    refuse_(fmt::format("'output' of state '{}' must be a number or a list of numbers", name), tree);
  std::vector<double> output;
  for (const Value& element : *tree.list()) output.push_back(formulas_.number(name, element));
  return output;
}

std::size_t ChartReader::target(std::size_t from, const std::string& name, const Value& where) const {
  std::size_t found = find(name, from);
  if (found == none)
    refuse_(fmt::format("state '{}' leads to '{}', which is none{}", states_[from].name, name,
                        near_or_all(name, all_names(states_), "the states are")),
            where);
  return found;
}

std::vector<ChartTransition> ChartReader::read_map(std::size_t from, const Value& map) const {
  std::vector<ChartTransition> to;
  for (const auto& [name, guard] : *map.map()) {
    const std::string subject = fmt::format("the guard from '{}' to '{}'", states_[from].name, name);
    const std::size_t where = target(from, name, guard);
    if (!guard.text()) refuse_(subject + " must be a formula, as \"u > 5 mm\"", guard);
    to.push_back({where, formulas_.read(subject, *guard.text(), guard), {}});
  }
  return to;
}

/// Reads [{to: cool, when: "u > 5", priority: 1, set: {tries: 0}}, ...]. Those with a priority are first, 1
/// before 2.
std::vector<ChartTransition> ChartReader::read_list(std::size_t from, const Value& list) const {
  std::vector<std::pair<double, ChartTransition>> ranked;
  for (const Value& entry : *list.list()) {
    ChartTransition made = read_transition(from, entry);
    const Value* priority = entry.find("priority");
    ranked.emplace_back(
        priority ? formulas_.number(states_[from].name, *priority) : std::numeric_limits<double>::infinity(),
        std::move(made));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ChartTransition> to;
  for (auto& [rank, transition] : ranked) to.push_back(std::move(transition));
  return to;
}

ChartTransition ChartReader::read_transition(std::size_t from, const Value& entry) const {
  const std::string& state = states_[from].name;
  const Value *name = entry.find("to"), *guard = entry.find("when"), *set = entry.find("set");
  if (!name || !name->text() || !guard || !guard->text())
    refuse_(fmt::format("a transition of state '{}' must be a map such as {{to: idle, when: \"u > 5\", "
                        "priority: 1, set: {{tries: 0}}}}",
                        state),
            entry);
  for (const ValueEntry& key : *entry.map())
    if (key.key != "to" && key.key != "when" && key.key != "set" && key.key != "priority")
      refuse_(
          fmt::format("a transition has no '{}'{}", key.key, near_or_all(key.key, transition_keys, "it has")),
          key.value);
  const std::string subject = fmt::format("the guard from '{}' to '{}'", state, *name->text());
  ChartTransition made{
      target(from, *name->text(), *name), formulas_.read(subject, *guard->text(), *guard), {}};
  if (set) made.set = formulas_.settings(fmt::format("'set' from '{}' to '{}'", state, *name->text()), *set);
  return made;
}

/// Reads {cool: 3 s}: transitions after all others, once the state has lasted so long.
std::vector<ChartTransition> ChartReader::read_timeouts(std::size_t from, const Value& map) const {
  if (!map.map())
    refuse_(fmt::format("'timeout' of state '{}' must be a map of target: time", states_[from].name), map);
  std::vector<ChartTransition> to;
  for (const auto& [name, time] : *map.map()) {
    const std::string subject = fmt::format("the time-out from '{}' to '{}'", states_[from].name, name);
    const std::size_t where = target(from, name, time);
    if (!time.text()) refuse_(subject + " must be a time, as 3 s", time);
    to.push_back({where, formulas_.read(subject, "after >= (" + *time.text() + ")", time), {}});
  }
  return to;
}

/// Copies the output of the enclosing state to states without an output.
void ChartReader::level_outputs() {
  std::size_t size = 0;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    ChartState& state = states_[s];
    if (state.output.empty() && state.parent != none) state.output = states_[state.parent].output;
    if (!state.output.empty() && size > 0 && state.output.size() != size)
      refuse_(fmt::format("state '{}' has {} and one before has {}; all must have the same number",
                          state.name, text::counted(state.output.size(), "output"), size),
              *trees_[s]);
    size = std::max(size, state.output.size());
  }
  for (ChartState& state : states_) state.output.resize(std::max<std::size_t>(size, 1), 0.0);
}

void ChartReader::refuse_unreachable(std::size_t first) const {
  std::vector<bool> reached(states_.size(), false);
  std::vector<std::size_t> open{first};
  const auto go_to = [&](std::size_t state) {
    open.push_back(state);
    if (states_[state].initial != none) open.push_back(states_[state].initial);
    if (states_[state].parent != none) open.push_back(states_[state].parent);
  };
  go_to(first);
  while (!open.empty()) {
    const std::size_t now = open.back();
    open.pop_back();
    if (reached[now]) continue;
    reached[now] = true;
    if (states_[now].parent != none && !reached[states_[now].parent]) open.push_back(states_[now].parent);
    for (const ChartTransition& transition : states_[now].to) {
      go_to(transition.target);
      go_to(leaf_of(transition.target));
    }
  }
  for (std::size_t s = 0; s < states_.size(); ++s)
    if (!reached[s])
      refuse_(fmt::format("no transition leads to state '{}' from '{}'; remove it or give it one",
                          states_[s].name, states_[first].name),
              *trees_[s]);
}

}  // namespace stepwire
