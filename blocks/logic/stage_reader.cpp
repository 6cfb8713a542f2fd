#include "blocks/logic/stage_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

}  // namespace

StageReader::StageReader(const Value& tree, std::size_t inputs, Refuse refuse)
    : tree_(tree), inputs_(inputs), refuse_(std::move(refuse)) {}

std::vector<Stage> StageReader::read() const {
  if (!tree_.map() || tree_.map()->empty())
    refuse_("it must be a map of states, as {idle: {to: {push: \"u > 5\"}}, push: {output: [1]}}", tree_);
  std::vector<Stage> stages;
  for (const auto& [name, tree] : *tree_.map()) stages.push_back(read_stage(name, tree));
  level_outputs(stages);
  return stages;
}

std::size_t StageReader::index_of(const std::string& name) const {
  const auto& entries = *tree_.map();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.key == name; });
  return found == entries.end() ? none : static_cast<std::size_t>(found - entries.begin());
}

std::string StageReader::names() const {
  std::vector<std::string> names;
  for (const ValueEntry& entry : *tree_.map()) names.push_back(entry.key);
  return fmt::format("{}", fmt::join(names, ", "));
}

Stage StageReader::read_stage(const std::string& name, const Value& tree) const {
  Stage stage{name, {}, {}};
  if (is_empty(tree)) return stage;
  if (!tree.map()) refuse_(fmt::format("state '{}' must be a map of output and to", name), tree);
  for (const auto& [key, value] : *tree.map()) {
    if (key == "output") {
      stage.output = read_output(name, value);
    } else if (key == "to") {
      if (!value.map())
        refuse_(fmt::format("'to' of state '{}' must be a map of target: guard", name), value);
      for (const ValueEntry& entry : *value.map()) stage.to.push_back(read_transition(name, entry));
    } else {
      refuse_(fmt::format("state '{}' has no '{}'; it has: output, to", name, key), value);
    }
  }
  return stage;
}

std::vector<double> StageReader::read_output(const std::string& name, const Value& tree) const {
  if (tree.text()) return {read_number(name, tree)};
  if (!tree.list() || tree.list()->empty())
    refuse_(fmt::format("'output' of state '{}' must be a number or a list of numbers", name), tree);
  std::vector<double> output;
  for (const Value& element : *tree.list()) output.push_back(read_number(name, element));
  return output;
}

double StageReader::read_number(const std::string& name, const Value& tree) const {
  double number = std::nan("");
  try {
    if (tree.text())
      number = expression::Expression(*tree.text(), [](std::string_view) { return false; })({});
  } catch (const expression::ExpressionError&) {
  }
  if (!std::isfinite(number))
    refuse_(fmt::format("'{}' in the output of state '{}' is no finite number", shown(tree), name), tree);
  return number;
}

Transition StageReader::read_transition(const std::string& name, const ValueEntry& entry) const {
  const std::size_t target = index_of(entry.key);
  if (target == none)
    refuse_(
        fmt::format("state '{}' leads to '{}', which is none; the states are {}", name, entry.key, names()),
        entry.value);
  return {target, read_guard(fmt::format("from '{}' to '{}'", name, entry.key), entry.value)};
}

Guard StageReader::read_guard(const std::string& subject, const Value& tree) const {
  if (!tree.text()) refuse_(fmt::format("the guard {} must be a formula, as \"u > 5 mm\"", subject), tree);
  try {
    Guard guard{expression::Expression(*tree.text(), [&](std::string_view n) { return variable(n) != none; }),
                {}};
    for (const std::string& name : guard.formula.variables()) guard.places.push_back(variable(name));
    return guard;
  } catch (const expression::ExpressionError& error) {
    const std::string inputs = inputs_ == 0   ? "no inputs"
                               : inputs_ == 1 ? "u"
                                              : fmt::format("u1 to u{}", inputs_);
    refuse_(fmt::format("the guard {}, '{}': {}; it may read {} and after", subject, *tree.text(),
                        error.what(), inputs),
            tree);
    throw;
  }
}

/// The time in the state stands behind all inputs.
std::size_t StageReader::variable(std::string_view name) const {
  if (name == "after") return inputs_;
  if (name == "u" && inputs_ == 1) return 0;
  for (std::size_t i = 0; i < inputs_; ++i)
    if (name == "u" + std::to_string(i + 1)) return i;
  return none;
}

void StageReader::level_outputs(std::vector<Stage>& stages) const {
  std::size_t size = 0;
  for (Stage& stage : stages) {
    if (!stage.output.empty() && size > 0 && stage.output.size() != size)
      refuse_(fmt::format("state '{}' has {} outputs and one before has {}; all must have the same number",
                          stage.name, stage.output.size(), size),
              *tree_.find(stage.name));
    size = std::max(size, stage.output.size());
  }
  for (Stage& stage : stages) stage.output.resize(std::max<std::size_t>(size, 1), 0.0);
}

void StageReader::refuse_unreachable(const std::vector<Stage>& stages, std::size_t first) const {
  std::vector<bool> reached(stages.size(), false);
  std::vector<std::size_t> open{first};
  while (!open.empty()) {
    const std::size_t now = open.back();
    open.pop_back();
    if (reached[now]) continue;
    reached[now] = true;
    for (const Transition& transition : stages[now].to) open.push_back(transition.target);
  }
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (!reached[i])
      refuse_(fmt::format("no transition leads to state '{}' from '{}'; remove it or give it one",
                          stages[i].name, stages[first].name),
              *tree_.find(stages[i].name));
}

}  // namespace stepwire
