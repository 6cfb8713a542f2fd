#include "engine/app/reference/example.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "engine/app/reference/words.hpp"

namespace stepwire::reference {

namespace {

using ExampleKeys = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t widest_line = 96;
constexpr std::size_t max_defaults = 2;

std::string source_text(const InputSpec& input) {
  if (input.list) return "[first, second]";
  return input.name == "u" ? "source" : input.name;
}

/// Returns a placeholder for a value that only the user can give.
std::string example_value(const ParameterSpec& spec) {
  switch (spec.kind) {
    case ParameterKind::file:
      return spec.doc.find(".fmu") == std::string::npos ? "record.csv" : "unit.fmu";
    case ParameterKind::text:
      return spec.name;
    case ParameterKind::texts:
      return "[" + spec.name + "]";
    case ParameterKind::vector:
      return "[1, 1]";
    case ParameterKind::matrix:
      return "[[1, 0], [0, 1]]";
    case ParameterKind::word:
      return spec.words.empty() ? "" : spec.words.front();
    case ParameterKind::flag:
      return "true";
    case ParameterKind::tree:
      return "{...}";
    default:
      return value_text(spec, {spec.range.at_least.value_or(1.0)});
  }
}

/// True for a number or word that is informative as an example; false for an absent bound and for empty text.
bool is_telling(const ParameterSpec& spec, const std::string& text) {
  const bool short_kind = spec.kind == ParameterKind::number || spec.kind == ParameterKind::per_element ||
                          spec.kind == ParameterKind::integer || spec.kind == ParameterKind::word;
  return short_kind && text.find("none") == std::string::npos && text[0] != '[';
}

void add_defaults(const BlockType& type, ExampleKeys& keys) {
  std::size_t count = 0;
  for (const ParameterSpec& parameter : type.parameters) {
    if (count == max_defaults) continue;
    const std::string text = default_text(type, parameter);
    if (!is_telling(parameter, text)) continue;
    keys.emplace_back(parameter.name, text);
    ++count;
  }
}

bool has_required(const BlockType& type) {
  return std::any_of(type.parameters.begin(), type.parameters.end(),
                     [](const ParameterSpec& parameter) { return parameter.required; });
}

/// Returns the inputs that a block with its default values requires.
std::set<std::string> required_inputs(const BlockType& type) {
  std::set<std::string> names;
  for (const InputSpec& input : type.inputs)
    if (!input.optional) names.insert(input.name);
  if (!type.configure || has_required(type)) return names;
  AnyBlock block(type);
  Configure is(names, 1e-3);
  try {
    type.configure(block.get(), is);
  } catch (const ParameterRefused&) {
    return names;
  }
  for (const auto& [input, reason] : is.answers().required) names.insert(input);
  return names;
}

ExampleKeys keys_to_show(const BlockType& type) {
  ExampleKeys keys = required_keys(type);
  auto behind_kind = keys.begin() + (type.presets.empty() ? 1 : 2);
  const std::set<std::string> required = required_inputs(type);
  for (const InputSpec& input : type.inputs)
    if (required.contains(input.name))
      behind_kind = keys.emplace(behind_kind, input.name, source_text(input)) + 1;
  if (type.presets.empty() && !has_required(type)) add_defaults(type, keys);
  return keys;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> required_keys(const BlockType& type) {
  ExampleKeys keys{{"block", type.name}};
  if (!type.presets.empty()) keys.emplace_back("preset", type.presets.front().name);
  for (const ParameterSpec& parameter : type.parameters)
    if (parameter.required) keys.emplace_back(parameter.name, example_value(parameter));
  return keys;
}

std::string block_example(const BlockType& type) {
  const std::string name = snake_case(type.name);
  std::string line = name + ": {", lines = name + ":";
  bool first = true;
  for (const auto& [key, value] : keys_to_show(type)) {
    line += (first ? "" : ", ") + key + ": " + value;
    lines += "\n  " + key + ": " + value;
    first = false;
  }
  return line.size() < widest_line ? line + "}" : lines;
}

}  // namespace stepwire::reference
