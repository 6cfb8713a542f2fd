#include "engine/app/simulink/workspace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "engine/app/simulink/matlab.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {

namespace {

bool has_control(const std::string& statement) {
  constexpr std::string_view words[] = {"if", "for", "while", "switch", "try", "function", "end"};
  return std::ranges::any_of(words, [&](std::string_view word) {
    return statement.starts_with(word) && (statement.size() == word.size() || statement[word.size()] == ' ' ||
                                           statement[word.size()] == '(');
  });
}

/// True for names that have another meaning: inputs of an Expression, and keys that --set replaces.
bool is_taken(const std::string& name) {
  static const std::set<std::string> keys{"step", "stop", "solver", "tolerance"};
  const bool is_input = name[0] == 'u' && name.find_first_not_of("0123456789", 1) == name.npos;
  return is_input || keys.contains(name);
}

/// Returns the value of a variable as formulas of its parameter.
Value as_parameter(const std::string& name, const Workspace::Variable& variable) {
  Value value = variable.value;
  if (variable.is_plain) {
    for (Cell& cell : value.cells) cell = Cell{cell.number};
    return value;
  }
  value.name = name;
  const std::string& text = variable.written;
  for (std::size_t i = 0; i < value.cells.size(); ++i) {
    Cell& cell = value.cells[i];
    if (value.is_scalar())
      cell = Cell{cell.number, text};
    else if (value.is_vector())
      cell = Cell{cell.number, fmt::format("{}.{}", text, i + 1)};
    else
      cell = Cell{cell.number, fmt::format("{}.{}.{}", text, i / value.columns + 1, i % value.columns + 1)};
  }
  return value;
}

}  // namespace

Workspace::Workspace(const Model& model, std::vector<std::string>& notes) {
  constexpr const char* callbacks[] = {"PreLoadFcn", "PostLoadFcn", "InitFcn"};
  const auto script_of = [&](const char* callback) {
    const auto script = model.texts.find(callback);
    return script == model.texts.end() ? std::string() : script->second;
  };
  std::vector<std::string> others;
  for (const char* callback : callbacks)
    for (const Assignment& one : assignments_of(script_of(callback), others)) ++counts_[one.name];
  for (const char* callback : callbacks)
    if (const std::string script = script_of(callback); !script.empty()) run(script, callback, notes);
}

void Workspace::run(const std::string& script, const std::string& callback, std::vector<std::string>& notes) {
  std::vector<std::string> others;
  const std::vector<Assignment> assignments = assignments_of(script, others);
  const bool branches =
      std::ranges::any_of(others, has_control) ||
      std::ranges::any_of(assignments, [](const Assignment& of) { return has_control(of.name); });
  if (branches) {
    notes.push_back(fmt::format(
        "{} has branches or loops and is not executed; give its variables as parameters", callback));
    return;
  }
  for (const std::string& statement : others)
    notes.push_back(fmt::format("{} has '{}', which is not executed", callback, statement.substr(0, 80)));
  for (const Assignment& one : assignments) {
    assign(one.name, one.expression, callback, notes);
    const auto made = variables_.find(one.name);
    if (made != variables_.end()) made->second.is_plain = counts_[one.name] > 1;
  }
}

void Workspace::assign(const std::string& name, const std::string& expression, const std::string& callback,
                       std::vector<std::string>& notes) {
  std::set<std::string> reads;
  try {
    Value value = evaluated(expression, [&](const std::string& read, bool is_function) {
      const auto found = variables_.find(read);
      if (found == variables_.end() && is_function) return Value::missing();
      if (found == variables_.end()) throw ValueError(fmt::format("reads '{}', which has no value", read));
      if (!found->second.is_plain) reads.insert(read);
      return as_parameter(read, found->second);
    });
    if (value.cells.empty()) throw ValueError("is empty");
    value.name.clear();
    Variable& variable = variables_[name];
    if (variable.written.empty()) variable.written = free_name(name);
    variable.value = std::move(value);
    variable.reads = std::move(reads);
  } catch (const ValueError& error) {
    variables_.erase(name);
    notes.push_back(fmt::format("{} sets {} = {}, which {}", callback, name,
                                on_one_line(expression).substr(0, 80), error.what()));
  }
}

std::string Workspace::free_name(const std::string& name) {
  const std::string valid = valid_name(name), wanted = valid + (is_taken(valid) ? "_" : "");
  std::string free = wanted;
  for (int i = 2; !written_.insert(free).second; ++i) free = fmt::format("{}_{}", wanted, i);
  return free;
}

Value Workspace::find(const std::string& name) {
  const auto found = variables_.find(name);
  if (found != variables_.end()) {
    Value value = as_parameter(name, found->second);
    value.is_missing = found->second.value.is_missing;
    return value;
  }
  Variable& variable = variables_[name];
  variable.written = free_name(name);
  variable.value = Value::of(std::numeric_limits<double>::quiet_NaN());
  variable.value.is_missing = true;
  return find(name);
}

std::set<std::string> Workspace::with_read(const std::set<std::string>& names) const {
  std::set<std::string> all = names;
  std::vector<std::string> open(names.begin(), names.end());
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    for (const std::string& read : variables_.at(name).reads)
      if (all.insert(read).second) open.push_back(read);
  }
  return all;
}

}  // namespace stepwire::simulink
