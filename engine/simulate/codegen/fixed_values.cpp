#include "engine/simulate/codegen/fixed_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/plan/change.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

bool is_numeric(ParameterKind kind) {
  return kind == ParameterKind::number || kind == ParameterKind::integer ||
         kind == ParameterKind::per_element || kind == ParameterKind::vector || kind == ParameterKind::matrix;
}

bool is_inside(const Range& range, double value) {
  return !(range.above && !(value > *range.above)) && !(range.at_least && !(value >= *range.at_least)) &&
         !(range.below && !(value < *range.below)) && !(range.at_most && !(value <= *range.at_most));
}

/// A member with its numbers.
std::string content_of(const MemberSpec& member, const AnyBlock& block) {
  Literals literals;
  literals.name_tables("x");
  const std::string text = member.literal(block.get(), literals);
  return text + literals.tables();
}

/// Other values of a parameter: all of its numbers changed, and each of them alone.
class Trials {
 public:
  Trials(const ParameterSpec& spec, const Value& value) : spec_(spec), value_(value) {
    const std::size_t count = numbers_of(value).size();
    for (const auto& change : changes()) {
      add(0, count, change);
      for (std::size_t k = 0; count > 1 && k < count; ++k) add(k, k + 1, change);
    }
  }

  const std::vector<Value>& values() const { return values_; }

 private:
  using Change = double (*)(double);

  static std::vector<Change> changes() {
    return {[](double x) { return 1.125 * x; }, [](double x) { return 0.5 * x; },
            [](double x) { return 2.0 * x; },   [](double x) { return x + 1.0; },
            [](double x) { return -x; },        [](double) { return 0.0; },
            [](double) { return 1.0; }};
  }

  void add(std::size_t first, std::size_t end, Change change) {
    Value value = value_;
    const auto alter = [&](double& number) {
      number = change(number);
      if (spec_.kind == ParameterKind::integer) number = std::round(number);
      return is_inside(spec_.range, number);
    };
    bool inside = true;
    const auto alter_all = [&](double* numbers) {
      for (std::size_t k = first; k < end; ++k) inside = alter(numbers[k]) && inside;
    };
    if (auto* number = std::get_if<double>(&value.content)) alter_all(number);
    if (auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) alter_all(vector->data());
    if (auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content)) alter_all(matrix->data());
    if (inside) values_.push_back(std::move(value));
  }

  const ParameterSpec& spec_;
  const Value& value_;
  std::vector<Value> values_;
};

/// A member that only the program itself computes, and that differs from the plan's; empty where there is
/// none.
std::string derived_change(const AnyBlock& made, const AnyBlock& before) {
  const BlockType& type = made.type();
  const bool prepares = can_prepare(before);
  std::vector<bool> derived(type.members.size(), true);
  for (const ParameterSpec& spec : type.parameters)
    if (spec.member >= 0) derived[static_cast<std::size_t>(spec.member)] = false;
  for (std::size_t m = 0; m < derived.size(); ++m)
    if (derived[m] && !(prepares && type.members[m].prepared.put) &&
        content_of(type.members[m], made) != content_of(type.members[m], before))
      return type.members[m].member;
  return "";
}

/// Why a block's parameter keeps its value in this plan.
std::string reason_in(const plan::Plan& plan, const diagram::Target& target) {
  const auto b = static_cast<std::size_t>(target.block);
  const diagram::DiagramBlock& block = plan.diagram.blocks[b];
  const ParameterSpec& spec = block.type().parameters[static_cast<std::size_t>(target.index)];
  const std::string name = diagram::name_of(plan.diagram, target);
  if (!is_numeric(spec.kind)) return fmt::format("{} is no number", name);
  if (!plan.blocks[b].written) return "";
  const Value value = spec.get(plan.blocks[b].written->get());
  for (const Trials trials(spec, value); const Value& other : trials.values()) {
    try {
      const plan::PlanChange change =
          plan::change_of(plan, {{target, {other, {}, "", false}, block.origin}}, {});
      if (!change.structure.empty()) return fmt::format("{} decides on sizes, connections or formulas", name);
      const std::string derived = derived_change(change.blocks.front().made, block.block);
      if (!derived.empty())
        return fmt::format("'{}' of {} follows from {}, and is computed before a run only", derived,
                           block.name, name);
    } catch (const yaml::Error&) {  // a value that the block refuses says nothing about the others
    }
  }
  return "";
}

}  // namespace

bool can_prepare(const AnyBlock& block) {
  return std::ranges::all_of(block.type().members, [&](const MemberSpec& member) {
    return !member.prepared.put || member.prepared.count(block.get()) > 0;
  });
}

std::string FixedValues::reason_of(const diagram::Target& target) {
  if (target.kind != diagram::Target::Kind::parameter) return "";
  const auto [known, is_new] = known_.try_emplace({target.block, target.index});
  if (is_new) known->second = reason_in(plan_, target);
  return known->second;
}

std::string FixedValues::reason_of(const diagram::ValueText& text) const {
  const ValueTexts all_vary(plan_.diagram, [](std::size_t) { return "x"; });
  if (all_vary.numbers(text.node, text.names)) return "";
  return fmt::format("{} has a unit of its own, or is no number",
                     text.node.is_scalar() ? "'" + text.node.text + "'" : "what follows from it");
}

std::string FixedValues::reason_of_bounds(std::size_t definition) const {
  const diagram::Definition& of = plan_.diagram.bindings->definitions[definition];
  for (const yaml::Entry& bound : of.bounds)
    if (const std::string reason = reason_of(diagram::ValueText{bound.value, of.scope, of.scope});
        !reason.empty())
      return reason;
  return "";
}

std::string FixedValues::reason(std::size_t definition) {
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
