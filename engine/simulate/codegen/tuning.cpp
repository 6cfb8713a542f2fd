#include "engine/simulate/codegen/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/member_items.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

/// Finds the parameters that must be fixed in a generated program. A parameter is fixed if something else
/// than a number depends on it, or a block member that is declared to depend on it (MemberSpec::follows).
class FixedValues {
 public:
  explicit FixedValues(const plan::Plan& plan) : plan_(plan) {}

  /// Returns the reason why a parameter, by its index in Diagram::parameters, is fixed; an empty text for one
  /// that may change.
  std::string reason(std::size_t definition) const;

 private:
  std::string reason_of(const diagram::Target& target) const;
  std::string reason_of(const diagram::ValueText& text) const;
  std::string matrix_formula(const yaml::Node& node, int scope) const;
  std::string reason_of_bounds(std::size_t definition) const;

  const plan::Plan& plan_;
};

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

/// True if a program without dynamic memory can call prepare() of this block.
bool can_prepare(const AnyBlock& block) {
  return std::ranges::all_of(block.type().members, [&](const MemberSpec& member) {
    return !member.prepared.put || member.prepared.count(block.get()) > 0;
  });
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

/// Marker numbers that no diagram contains. They replace the variable numbers, so that the places that depend
/// on them can be found.
class Marks {
 public:
  static constexpr double first = 7.0e14;

  double next(const PreparedBlock::Number& prepared, const Tuning::Copy& copy, std::size_t block) {
    all_.push_back({prepared, copy, block});
    return first + static_cast<double>(all_.size() - 1);
  }

  struct Mark {
    PreparedBlock::Number prepared;
    Tuning::Copy copy;
    std::size_t block;  ///< block that prepares it; `none` for a copy
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Mark* of(double number) const {
    const double index = number - first;
    return index >= 0.0 && index < static_cast<double>(all_.size()) ? &all_[static_cast<std::size_t>(index)]
                                                                    : nullptr;
  }

 private:
  std::vector<Mark> all_;
};

void put_numbers(Value& value, const std::vector<double>& numbers) {
  if (auto* number = std::get_if<double>(&value.content)) *number = numbers.front();
  if (auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    std::copy(numbers.begin(), numbers.end(), vector->data());
  if (auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    std::copy(numbers.begin(), numbers.end(), matrix->data());
}

/// Returns the items of these members of a block.
std::vector<bool> items_of(const std::vector<bool>& members, const AnyBlock& block) {
  std::vector<bool> items;
  for (std::size_t m = 0; m < members.size(); ++m) {
    plan::MemberItems of_member;
    of_member.add(block.type().members[m], block.get());
    items.insert(items.end(), of_member.items().size(), members[m]);
  }
  return items;
}

class Tuner {
 public:
  explicit Tuner(const plan::Plan& plan) : plan_(plan), all_(*plan.diagram.bindings) {}

  Tuning take() {
    choose();
    if (tuning_.parameters.empty()) return std::move(tuning_);
    gather_bindings();
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) take_parameter(i);
    for (const int block : plan_.memory_order) take_block(static_cast<std::size_t>(block));
    place_numbers();
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) take_place(i);
    return std::move(tuning_);
  }

 private:
  const diagram::Binding& binding(std::size_t i) const {
    return all_.bindings[static_cast<std::size_t>(tuning_.bindings[i])];
  }

  void choose() {
    const FixedValues fixed(plan_);
    std::set<std::string> taken;
    for (std::size_t d = 0; d < plan_.diagram.parameters.size(); ++d) {
      const std::string& name = plan_.diagram.parameters[d].name;
      if (const std::string reason = fixed.reason(d); !reason.empty()) {
        tuning_.fixed.push_back({name, reason});
        continue;
      }
      tuning_.parameters.push_back(static_cast<int>(d));
      tuning_.members[static_cast<int>(d)] = free_member(name, taken);
    }
  }

  void gather_bindings() {
    for (std::size_t b = 0; b < all_.bindings.size(); ++b)
      if (std::ranges::any_of(all_.bindings[b].uses, [&](int d) { return follows(d); }))
        tuning_.bindings.push_back(static_cast<int>(b));
  }

  /// True for a parameter that may change.
  bool follows(int definition) const { return tuning_.members.contains(definition); }

  const BlockType& type(std::size_t block) const { return plan_.diagram.blocks[block].type(); }

  AnyBlock& marked(std::size_t block) {
    return marked_.try_emplace(block, plan_.diagram.blocks[block].block).first->second;
  }

  /// Marks the numbers of a block's parameter.
  void take_parameter(std::size_t i) {
    const diagram::Target& target = binding(i).target;
    if (target.kind != diagram::Target::Kind::parameter) return;
    const auto block = static_cast<std::size_t>(target.block);
    const ParameterSpec& spec = type(block).parameters[static_cast<std::size_t>(target.index)];
    std::vector<bool>& members = members_[block];
    members.resize(type(block).members.size(), false);
    if (spec.member < 0) return;
    members[static_cast<std::size_t>(spec.member)] = true;
    Value value = spec.get(marked(block).get());
    std::vector<double> marks;
    for (std::size_t k = 0; k < numbers_of(value).size(); ++k)
      marks.push_back(marks_.next({}, {0, i, k}, Marks::none));
    put_numbers(value, marks);
    spec.set(marked(block).get(), value);
  }

  /// Marks the numbers that a block prepares, in memory order.
  void take_block(std::size_t block) {
    const auto found = members_.find(block);
    if (found == members_.end()) return;
    const AnyBlock& of_plan = plan_.diagram.blocks[block].block;
    for (std::size_t m = 0; m < type(block).members.size() && can_prepare(of_plan); ++m) {
      const PreparedMember& prepared = type(block).members[m].prepared;
      if (!prepared.put) continue;
      found->second[m] = true;
      std::vector<double> marks;
      for (std::size_t k = 0; k < static_cast<std::size_t>(prepared.count(of_plan.get())); ++k)
        marks.push_back(marks_.next({0, m, k}, {}, block));
      prepared.put(marked(block).get(), marks.data(), static_cast<Index>(marks.size()));
    }
    tuning_.variable.push_back({block, items_of(found->second, of_plan)});
  }

  void place_numbers() {
    const plan::NumberTable actual(plan_, tuning_.variable,
                                   [&](std::size_t b) { return plan_.diagram.blocks[b].block.get(); });
    const plan::NumberTable table(plan_, tuning_.variable, [&](std::size_t b) { return marked(b).get(); });
    tuning_.numbers.assign(actual.data(), actual.data() + actual.size());
    std::map<std::size_t, PreparedBlock> prepared;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const Marks::Mark* mark = marks_.of(table.data()[i]);
      if (!mark) continue;
      if (mark->block == Marks::none) {
        tuning_.copies.push_back({i, mark->copy.binding, mark->copy.element});
      } else {
        prepared[mark->block].block = mark->block;
        prepared[mark->block].numbers.push_back({i, mark->prepared.member, mark->prepared.part});
      }
    }
    for (auto& [block, one] : prepared) tuning_.prepared.push_back(std::move(one));
  }

  /// Adds the numbers of constants on wires and of initial values, after those of blocks.
  void take_place(std::size_t i) {
    const diagram::Target& target = binding(i).target;
    if (target.kind == diagram::Target::Kind::parameter) return;
    const plan::PlannedBlock& planned = plan_.blocks[static_cast<std::size_t>(target.block)];
    const auto index = static_cast<std::size_t>(target.index);
    const bool is_state = target.kind == diagram::Target::Kind::initial;
    const plan::SignalSlot& slot =
        is_state ? planned.states[index] : planned.inputs[index][static_cast<std::size_t>(target.element)];
    const std::size_t first = is_state ? 0 : first_meant(target);
    for (std::size_t k = 0; k < static_cast<std::size_t>(slot.size); ++k) {
      tuning_.places[slot.offset + k] = tuning_.numbers.size();
      if (is_state && !planned.initial.empty())  // a guard resets it
        tuning_.places[planned.initial[index].offset + k] = tuning_.numbers.size();
      tuning_.copies.push_back({tuning_.numbers.size(), i, first + k});
      tuning_.numbers.push_back(is_state ? initial(target, k)
                                         : plan_.constants[slot.offset - plan_.layout.constants + k]);
    }
  }

  /// Returns the index of the first number of a constant on a wire that the target sets.
  std::size_t first_meant(const diagram::Target& target) const {
    return plan::constant_slot(
               plan_.diagram.blocks[static_cast<std::size_t>(target.block)]
                   .inputs[static_cast<std::size_t>(target.index)][static_cast<std::size_t>(target.element)])
        .offset;
  }

  double initial(const diagram::Target& target, std::size_t k) const {
    for (const diagram::InitialValue& one :
         plan_.diagram.blocks[static_cast<std::size_t>(target.block)].initial)
      if (one.state == target.index)
        return one.value[one.value.size() == 1 ? 0 : static_cast<Eigen::Index>(k)];
    return 0.0;
  }

  const plan::Plan& plan_;
  const diagram::Bindings& all_;
  Tuning tuning_;
  Marks marks_;
  std::map<std::size_t, AnyBlock> marked_;
  std::map<std::size_t, std::vector<bool>> members_;
};

}  // namespace

Tuning tuning_of(const plan::Plan& plan) {
  return Tuner(plan).take();
}

}  // namespace stepwire::codegen
