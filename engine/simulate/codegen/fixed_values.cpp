#include "engine/simulate/codegen/fixed_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

bool is_numeric(ParameterKind kind) {
  return kind == ParameterKind::number || kind == ParameterKind::integer ||
         kind == ParameterKind::per_element || kind == ParameterKind::vector || kind == ParameterKind::matrix;
}

bool is_finite(const Value& value) {
  return std::ranges::all_of(numbers_of(value), [](double number) { return std::isfinite(number); });
}

bool is_derived(const BlockType& type, const MemberSpec& member) {
  const auto index = static_cast<int>(&member - type.members.data());
  return std::ranges::none_of(type.parameters,
                              [&](const ParameterSpec& spec) { return spec.member == index; });
}

/// Returns a member that depends on a parameter and that only stepwire itself computes; nullptr without one.
const MemberSpec* member_from(const ParameterSpec& spec, const AnyBlock& block) {
  const bool prepares = can_prepare(block);
  const std::vector<MemberSpec>& all = block.type().members;
  const auto found = std::ranges::find_if(all, [&](const MemberSpec& member) {
    return is_derived(block.type(), member) && !(prepares && member.prepared.put) &&
           (!member.follows || std::ranges::find(*member.follows, spec.name) != member.follows->end());
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

bool can_prepare(const AnyBlock& block) {
  return std::ranges::all_of(block.type().members, [&](const MemberSpec& member) {
    return !member.prepared.put || member.prepared.count(block.get()) > 0;
  });
}

std::string FixedValues::reason_of(const diagram::Target& target) const {
  if (target.kind != diagram::Target::Kind::parameter) return "";
  const diagram::DiagramBlock& block = plan_.diagram.blocks[static_cast<std::size_t>(target.block)];
  const ParameterSpec& spec = block.type().parameters[static_cast<std::size_t>(target.index)];
  const std::string name = diagram::name_of(plan_.diagram, target);
  if (!spec.formulas.empty())
    return fmt::format("{} {}; wired as an input of {}, u: [.., $name], it can be changed", name,
                       spec.kind == ParameterKind::text ? "is a formula" : "has formulas, which are code",
                       block.name);
  if (!is_numeric(spec.kind)) return fmt::format("{} is no number", name);
  if (spec.structural) return fmt::format("{} decides on sizes or connections", name);
  const MemberSpec* member = member_from(spec, block.block);
  if (!member)
    return is_finite(spec.get(block.block.get()))
               ? ""
               : fmt::format("{} is infinite, which stands for none", name);
  return fmt::format("'{}' of {} follows from {}, and is computed before a run only", member->member,
                     block.name, name);
}

std::string FixedValues::reason_of(const diagram::ValueText& text) const {
  const ValueTexts all_vary(plan_.diagram, [](std::size_t) { return "x"; });
  if (all_vary.numbers(text.node, text.names)) return "";
  if (const std::string formula = matrix_formula(text.node, text.names); !formula.empty())
    return fmt::format("'{}' is a formula of matrices, which is computed before a run only", formula);
  return fmt::format("{} has a unit of its own, or is no number",
                     text.node.is_scalar() ? "'" + text.node.text + "'" : "what follows from it");
}

/// Returns the first matrix formula in a value; an empty text without one.
std::string FixedValues::matrix_formula(const yaml::Node& node, int scope) const {
  for (const yaml::Node& item : node.items)
    if (std::string formula = matrix_formula(item, scope); !formula.empty()) return formula;
  if (const yaml::Node* value = node.is_map() ? node.find("value") : nullptr)
    return matrix_formula(*value, scope);
  const ValueTexts all_vary(plan_.diagram, [](std::size_t) { return "x"; });
  const bool is_formula = node.is_scalar() && node.text.starts_with('=');
  return is_formula && !all_vary.numbers(node, scope) ? node.text : "";
}

std::string FixedValues::reason_of_bounds(std::size_t definition) const {
  const diagram::Definition& of = plan_.diagram.bindings->definitions[definition];
  for (const yaml::Entry& bound : of.bounds)
    if (const std::string reason = reason_of(diagram::ValueText{bound.value, of.scope, of.scope});
        !reason.empty())
      return reason;
  return "";
}

std::string FixedValues::reason(std::size_t definition) const {
  const diagram::Bindings& all = *plan_.diagram.bindings;
  const auto of_definition = [&](std::size_t d) -> std::string {
    return numbers_of(plan_.diagram.parameters[d].value).empty() ? "is no number" : "";
  };
  if (const std::string reason = of_definition(definition); !reason.empty()) return reason;
  const diagram::Variation variation(plan_.diagram, {plan_.diagram.parameters[definition].name});
  if (variation.structural()) return "the diagram's times, records or parts follow from it";
  if (const std::string reason = reason_of_bounds(definition); !reason.empty()) return reason;
  for (const int d : variation.definitions()) {
    const auto index = static_cast<std::size_t>(d);
    if (!of_definition(index).empty())
      return fmt::format("{} is no number", plan_.diagram.parameters[index].name);
    for (const std::string& reason : {reason_of(all.definitions[index].text), reason_of_bounds(index)})
      if (!reason.empty()) return reason;
  }
  for (const int b : variation.bindings()) {
    const diagram::Binding& binding = all.bindings[static_cast<std::size_t>(b)];
    for (const std::string& reason : {reason_of(binding.target), reason_of(binding.text)})
      if (!reason.empty()) return reason;
  }
  return "";
}

}  // namespace stepwire::codegen
