#include "engine/model/diagram/variation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/own_value.hpp"

namespace stepwire::diagram {

namespace {

/// Times and methods of the file itself, which a call may set as well.
const std::vector<std::string> head_names = {"step", "stop", "solver", "tolerance"};

/// True for a number with or without a unit that YAML reads as the same text.
bool is_plain_quantity(const std::string& text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || std::strchr("+-. /^*", c); };
  return !text.empty() && text.front() != ' ' && text.back() != ' ' && text.front() != '*' &&
         std::ranges::all_of(text, plain) && unit::parse_quantity(text);
}

/// Returns the name of an input, "u", or "u.2" for the second source of a list.
std::string input_name(const InputSpec& spec, std::size_t element) {
  return spec.list ? fmt::format("{}.{}", spec.name, element + 1) : spec.name;
}

/// Returns the parameter, state or constant input that a key sets; std::nullopt for other keys.
std::optional<Target> target_of(const DiagramBlock& block, int index, const std::string& key) {
  const BlockType& type = block.type();
  if (const ParameterSpec* spec = type.parameter(key))
    return Target{Target::Kind::parameter, index, static_cast<int>(spec - type.parameters.data()), 0};
  if (const int state = state_of_key(type, key); state >= 0)
    return Target{Target::Kind::initial, index, state, 0};
  for (std::size_t i = 0; i < block.inputs.size(); ++i)
    for (std::size_t k = 0; k < block.inputs[i].size(); ++k)
      if (block.inputs[i][k].block < 0 && input_name(type.inputs[i], k) == key)
        return Target{Target::Kind::constant, index, static_cast<int>(i), static_cast<int>(k)};
  return std::nullopt;
}

bool uses_any(const ParameterUses& uses, const std::vector<char>& changed) {
  return std::ranges::any_of(uses, [&](int used) { return changed[static_cast<std::size_t>(used)]; });
}

/// Returns for each definition whether it is one of these or depends on them.
std::vector<char> changed_by(const std::vector<int>& given, const Bindings& all) {
  std::vector<char> changed(all.definitions.size(), 0);
  for (const int definition : given) changed[static_cast<std::size_t>(definition)] = 1;
  for (std::size_t d = 0; d < changed.size(); ++d)
    if (uses_any(all.definitions[d].uses, changed)) changed[d] = 1;
  return changed;
}

/// Returns all settable names, for suggestions.
std::vector<std::string> names_of(const Diagram& diagram) {
  std::vector<std::string> names = head_names;
  for (const DiagramParameter& parameter : diagram.parameters) names.push_back(parameter.name);
  for (const DiagramBlock& block : diagram.blocks)
    for (const ParameterSpec& spec : block.type().parameters) names.push_back(block.name + "." + spec.name);
  return names;
}

}  // namespace

std::string name_of(const Diagram& diagram, const Target& target) {
  const DiagramBlock& block = diagram.blocks[static_cast<std::size_t>(target.block)];
  const BlockType& type = block.type();
  const auto index = static_cast<std::size_t>(target.index);
  switch (target.kind) {
    case Target::Kind::parameter:
      return block.name + "." + type.parameters[index].name;
    case Target::Kind::initial:
      return block.name + "." + initial_key(type, type.states[index]);
    default:
      return block.name + "." + input_name(type.inputs[index], static_cast<std::size_t>(target.element));
  }
}

yaml::Node value_of_text(const std::string& text, const std::string& place) {
  if (!is_plain_quantity(text)) return yaml::parse_document(text, place).root;
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = text;
  return node;
}

yaml::Node value_of_number(double number, const std::optional<unit::Dimension>& dimension) {
  const bool has_unit = dimension && *dimension != unit::Dimension{};
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = has_unit ? fmt::format("{} {}", number, unit::si_name(*dimension)) : fmt::format("{}", number);
  return node;
}

yaml::Message nearest_name(const Diagram& diagram, const std::string& text) {
  return yaml::did_you_mean(text, names_of(diagram));
}

Variation::Variation(const Diagram& diagram, const std::vector<std::string>& names) {
  for (const std::string& name : names) names_.push_back(find(diagram, name));
  follow(diagram);
}

bool Variation::structural() const {
  return std::ranges::any_of(names_, &Name::structural);
}

std::optional<Variation::Name> find_name(const Diagram& diagram, const std::string& text) {
  Variation::Name name{text, -1, {}, false};
  for (std::size_t i = 0; i < diagram.parameters.size(); ++i)
    if (diagram.parameters[i].name == text) {
      name.definition = static_cast<int>(i);
      return name;
    }
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const DiagramBlock& block = diagram.blocks[b];
    if (!text.starts_with(block.name + ".")) continue;
    const auto target = target_of(block, static_cast<int>(b), text.substr(block.name.size() + 1));
    if (!target) continue;
    name.target = *target;
    return name;
  }
  name.structural = std::ranges::count(head_names, text) > 0;
  return name.structural ? std::optional(name) : std::nullopt;
}

Variation::Name Variation::find(const Diagram& diagram, const std::string& text) const {
  if (auto name = find_name(diagram, text)) return *std::move(name);
  throw yaml::Error(yaml::Fault{{diagram.file, {}},
                                text,
                                fmt::format("there is no parameter '{}'", text) + nearest_name(diagram, text),
                                {}});
}

bool Variation::decides(const Diagram& diagram, int definition) {
  const Bindings& all = *diagram.bindings;
  const std::vector<char> changed = changed_by({definition}, all);
  for (std::size_t d = 0; d < all.definitions.size(); ++d) {
    const ParameterScope& scope = all.scopes[static_cast<std::size_t>(all.definitions[d].scope)];
    if (changed[d] && scope.is_structural(all.definitions[d].name)) return true;
  }
  return false;
}

void Variation::follow(const Diagram& diagram) {
  const Bindings& all = *diagram.bindings;
  std::vector<int> given;
  for (Name& name : names_) {
    if (name.definition < 0 && !name.structural) targets_.push_back(name.target);
    if (name.definition < 0) continue;
    given.push_back(name.definition);
    name.structural = decides(diagram, name.definition);
  }
  const std::vector<char> changed = changed_by(given, all);
  for (std::size_t d = 0; d < all.definitions.size(); ++d)
    if (changed[d] && std::ranges::count(given, static_cast<int>(d)) == 0)
      definitions_.push_back(static_cast<int>(d));
  for (std::size_t b = 0; b < all.bindings.size(); ++b) {
    if (!uses_any(all.bindings[b].uses, changed)) continue;
    bindings_.push_back(static_cast<int>(b));
    targets_.push_back(all.bindings[b].target);
  }
}

}  // namespace stepwire::diagram
