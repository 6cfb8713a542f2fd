// More than 250 lines: what a chart may say is read and checked by one recursion over its tree.
#include "blocks/logic/chart_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stepwire {

namespace {

/// `name:` with nothing behind it is a state without output and transitions.
bool is_empty(const Value& tree) {
  return tree.text() && (tree.text()->empty() || *tree.text() == "~");
}

std::string shown(const Value& tree) {
  return tree.text() ? *tree.text() : "this";
}

std::size_t position_in(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? ChartNames::none : static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::size_t ChartNames::counter(std::string_view name) const {
  return position_in(counters, name);
}

std::size_t ChartNames::place(std::string_view name) const {
  if (name == "after") return after();
  if (const std::size_t found = counter(name); found != none) return input_count + found;
  if (!inputs.empty()) return position_in(inputs, name);
  if (name == "u" && input_count == 1) return 0;
  for (std::size_t i = 0; i < input_count; ++i)
    if (name == "u" + std::to_string(i + 1)) return i;
  return none;
}

std::string ChartNames::text() const {
  std::string all = !inputs.empty()    ? fmt::format("{}", fmt::join(inputs, ", "))
                    : input_count == 0 ? "no inputs"
                    : input_count == 1 ? "u"
                                       : fmt::format("u1 to u{}", input_count);
  if (!counters.empty()) all += fmt::format(", {}", fmt::join(counters, ", "));
  return all + " and after";
}

ChartReader::ChartReader(const Value& tree, ChartNames names, Refuse refuse)
    : tree_(tree), names_(std::move(names)), refuse_(std::move(refuse)) {
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
  std::vector<std::string> names;
  for (const ChartState& state : states_) names.push_back(state.name);
  return fmt::format("{}", fmt::join(names, ", "));
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
    made.enter = read_settings(fmt::format("'enter' of state '{}'", name), value);
  } else if (key == "exit") {
    made.exit = read_settings(fmt::format("'exit' of state '{}'", name), value);
  } else if (key == "each") {
    made.each = read_settings(fmt::format("'each' of state '{}'", name), value);
  } else if (key == "initial") {
    made.initial = initial_of(state);
  } else if (key == "history") {
    if (shown(value) != "true" && shown(value) != "false")
      refuse_(fmt::format("'history' of state '{}' must be true or false", name), value);
    made.history = shown(value) == "true";
    if (made.initial == none)
      refuse_(fmt::format("state '{}' holds no states that it could remember", name), value);
  } else if (key != "states" && key != "timeout") {
    refuse_(fmt::format("state '{}' has no '{}'; it has: output, to, timeout, enter, exit, each, states, "
                        "initial, history",
                        name, key),
            value);
  }
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
  if (tree.text()) return {read_number(name, tree)};
  if (!tree.list() || tree.list()->empty())
    refuse_(fmt::format("'output' of state '{}' must be a number or a list of numbers", name), tree);
  std::vector<double> output;
  for (const Value& element : *tree.list()) output.push_back(read_number(name, element));
  return output;
}

double ChartReader::read_number(const std::string& name, const Value& tree) const {
  double number = std::numeric_limits<double>::quiet_NaN();
  try {
    if (tree.text())
      number = expression::Expression(*tree.text(), [](std::string_view) { return false; })({});
  } catch (const expression::ExpressionError&) {
  }
  if (!std::isfinite(number))
    refuse_(fmt::format("'{}' in the output of state '{}' is no finite number", shown(tree), name), tree);
  return number;
}

std::size_t ChartReader::target(std::size_t from, const std::string& name, const Value& where) const {
  std::size_t found = find(name, from);
  if (found == none)
    refuse_(fmt::format("state '{}' leads to '{}', which is none; the states are {}", states_[from].name,
                        name, names()),
            where);
  return found;
}

std::vector<ChartTransition> ChartReader::read_map(std::size_t from, const Value& map) const {
  std::vector<ChartTransition> to;
  for (const auto& [name, guard] : *map.map()) {
    const std::string subject = fmt::format("the guard from '{}' to '{}'", states_[from].name, name);
    const std::size_t where = target(from, name, guard);
    if (!guard.text()) refuse_(subject + " must be a formula, as \"u > 5 mm\"", guard);
    to.push_back({where, read_formula(subject, *guard.text(), guard), {}});
  }
  return to;
}

/// [{to: cool, when: "u > 5", priority: 1, set: {tries: 0}}, ...]: those with a priority come first, 1 before
/// 2.
std::vector<ChartTransition> ChartReader::read_list(std::size_t from, const Value& list) const {
  std::vector<std::pair<double, ChartTransition>> ranked;
  for (const Value& entry : *list.list()) {
    const Value *name = entry.find("to"), *guard = entry.find("when"), *set = entry.find("set"),
                *priority = entry.find("priority");
    if (!name || !name->text() || !guard || !guard->text())
      refuse_(fmt::format("a transition of state '{}' must be a map such as {{to: idle, when: \"u > 5\", "
                          "priority: 1, set: {{tries: 0}}}}",
                          states_[from].name),
              entry);
    for (const ValueEntry& key : *entry.map())
      if (key.key != "to" && key.key != "when" && key.key != "set" && key.key != "priority")
        refuse_(fmt::format("a transition has no '{}'; it has: to, when, priority, set", key.key), key.value);
    const std::string subject = fmt::format("the guard from '{}' to '{}'", states_[from].name, *name->text());
    ChartTransition made{
        target(from, *name->text(), *name), read_formula(subject, *guard->text(), *guard), {}};
    if (set)
      made.set =
          read_settings(fmt::format("'set' from '{}' to '{}'", states_[from].name, *name->text()), *set);
    ranked.emplace_back(
        priority ? read_number(states_[from].name, *priority) : std::numeric_limits<double>::infinity(),
        std::move(made));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ChartTransition> to;
  for (auto& [rank, transition] : ranked) to.push_back(std::move(transition));
  return to;
}

/// {cool: 3 s}: after all other transitions, where the state has lasted so long.
std::vector<ChartTransition> ChartReader::read_timeouts(std::size_t from, const Value& map) const {
  if (!map.map())
    refuse_(fmt::format("'timeout' of state '{}' must be a map of target: time", states_[from].name), map);
  std::vector<ChartTransition> to;
  for (const auto& [name, time] : *map.map()) {
    const std::string subject = fmt::format("the time-out from '{}' to '{}'", states_[from].name, name);
    const std::size_t where = target(from, name, time);
    if (!time.text()) refuse_(subject + " must be a time, as 3 s", time);
    to.push_back({where, read_formula(subject, "after >= (" + *time.text() + ")", time), {}});
  }
  return to;
}

std::vector<ChartSetting> ChartReader::read_settings(const std::string& subject, const Value& map) const {
  if (!map.map()) refuse_(subject + " must be a map of counter: formula", map);
  std::vector<ChartSetting> settings;
  for (const auto& [name, value] : *map.map()) {
    const std::size_t counter = names_.counter(name);
    if (counter == ChartNames::none)
      refuse_(fmt::format("{} sets '{}', which is no counter; {}", subject, name,
                          names_.counters.empty()
                              ? "name them with their first values: counters: {tries: 0}"
                              : fmt::format("the counters are {}", fmt::join(names_.counters, ", "))),
              value);
    if (!value.text()) refuse_(fmt::format("{} must be a formula", subject), value);
    settings.push_back({counter, read_formula(subject, *value.text(), value)});
  }
  return settings;
}

ChartFormula ChartReader::read_formula(const std::string& subject, const std::string& text,
                                       const Value& where) const {
  try {
    ChartFormula made{
        expression::Expression(text, [&](std::string_view n) { return names_.place(n) != ChartNames::none; }),
        {}};
    for (const std::string& name : made.formula.variables()) made.places.push_back(names_.place(name));
    return made;
  } catch (const expression::ExpressionError& error) {
    refuse_(fmt::format("{}, '{}': {}; it may read {}", subject, text, error.what(), names_.text()), where);
    throw;
  }
}

/// A state without an output has that of the state that holds it.
void ChartReader::level_outputs() {
  std::size_t size = 0;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    ChartState& state = states_[s];
    if (state.output.empty() && state.parent != none) state.output = states_[state.parent].output;
    if (!state.output.empty() && size > 0 && state.output.size() != size)
      refuse_(fmt::format("state '{}' has {} outputs and one before has {}; all must have the same number",
                          state.name, state.output.size(), size),
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
