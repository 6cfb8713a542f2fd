#include "engine/model/plan/change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/configuring.hpp"
#include "engine/model/plan/element_slot.hpp"
#include "engine/model/plan/member_items.hpp"

namespace stepwire::plan {

namespace {

MemberItems items_of(const MemberSpec& member, const AnyBlock& block) {
  MemberItems items;
  items.add(member, block.get());
  return items;
}

bool has_same_members(const AnyBlock& a, const AnyBlock& b) {
  return std::ranges::all_of(
      a.type().members, [&](const MemberSpec& member) { return items_of(member, a) == items_of(member, b); });
}

std::string outline_of(const AnyBlock& block) {
  return MemberItems(block.type(), block.get()).outline();
}

Eigen::Index size_of(const Value& value) {
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) return vector->size();
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
  return matrix ? matrix->size() : 1;
}

/// True for a single number, alone or repeated for each of `size` elements.
bool is_one_number(const Value& value, Eigen::Index size) {
  const auto* numbers = std::get_if<Eigen::VectorXd>(&value.content);
  if (!numbers || (numbers->size() != 1 && numbers->size() != size)) return false;
  return std::ranges::all_of(*numbers, [&](double number) { return number == (*numbers)[0]; });
}

/// True where a block with this configuration fits into a plan made for another. A block that has become
/// smooth fits as well, since the plan already allows for jumps.
bool fits(Configuration made, const Configuration& planned) {
  if (made.smooth) made.smooth = planned.smooth;
  return made == planned;
}

/// Collects the changes of all blocks.
class Changing {
 public:
  Changing(const Plan& plan, const WrittenBlocks& written) : plan_(plan), written_(written) {}

  void add(const diagram::ChangedValue& value) {
    switch (value.target.kind) {
      case diagram::Target::Kind::parameter:
        return set_parameter(value);
      case diagram::Target::Kind::initial:
        return set_initial(value);
      default:
        return set_constant(value);
    }
  }

  PlanChange take() {
    for (auto& [block, written] : changed_) rebuild(block, std::move(written));
    faults_.throw_if_any();
    return std::move(change_);
  }

 private:
  const diagram::DiagramBlock& block_of(const diagram::Target& target) const {
    return plan_.diagram.blocks[static_cast<std::size_t>(target.block)];
  }

  void refuse_structure(std::size_t block, const std::string& name, const std::string& what) {
    if (change_.structure.empty())
      change_.structure = fmt::format("{}.{}: {}", plan_.diagram.blocks[block].name, name, what);
  }

  /// Refuses a new unit: the units of wires are fixed in the plan. A bare number has the previous unit.
  void check_unit(const diagram::ChangedValue& value, const std::optional<unit::Dimension>& known,
                  const diagram::EachUnit& known_each, const std::string& name) {
    const auto& given = value.value.dimension;
    const bool has_other_elements = !value.value.each.empty() && value.value.each != known_each;
    if (has_other_elements || (given && (given != known || (given->zeros && given->zeros != known->zeros) ||
                                         (given->per_difference && !known->per_difference))))
      refuse_structure(static_cast<std::size_t>(value.target.block), name,
                       "the value has another unit, or one where it had none");
  }

  void check_parameter_unit(const diagram::ChangedValue& value, const diagram::DiagramBlock& known,
                            std::size_t index) {
    const diagram::EachUnit* const each = known.elements_of(index);
    check_unit(value, known.parameter_dimensions[index], each ? *each : diagram::EachUnit{},
               known.type().parameters[index].name);
  }

  AnyBlock& written(std::size_t block) {
    const auto found = changed_.find(block);
    if (found != changed_.end()) return found->second;
    const auto before = written_.find(block);
    const auto& planned = plan_.blocks[block].written;
    const AnyBlock& from = before != written_.end() ? before->second
                           : planned                ? *planned
                                                    : plan_.diagram.blocks[block].block;
    return changed_.emplace(block, from).first->second;
  }

  void set_parameter(const diagram::ChangedValue& value) {
    const auto block = static_cast<std::size_t>(value.target.block);
    const auto index = static_cast<std::size_t>(value.target.index);
    const diagram::DiagramBlock& known = block_of(value.target);
    const ParameterSpec& spec = known.type().parameters[index];
    if (!diagram::demanded_dimension(spec)) check_parameter_unit(value, known, index);
    if (&known.type() == &diagram::guard_type() && spec.structural)
      refuse_structure(block, spec.name, "the plan has other states that are reset");
    if (known.type().file_output) refuse_structure(block, spec.name, "the block writes a file");
    spec.set(written(block).get(), value.value.value);
  }

  /// True where the block's configuration depends on whether the file gives an initial value.
  bool asks_for(std::size_t block, int state) const {
    const auto& says = plan_.blocks[block].configuration;
    const auto& states = plan_.diagram.blocks[block].type().states;
    return says && says->asked_initial.contains(states[static_cast<std::size_t>(state)].name);
  }

  void set_initial(const diagram::ChangedValue& value) {
    const auto block = static_cast<std::size_t>(value.target.block);
    const auto& all = block_of(value.target).initial;
    const auto same = [&](const diagram::InitialValue& initial) {
      return initial.state == value.target.index;
    };
    const auto known = std::ranges::find_if(all, same);
    const auto& numbers = std::get<Eigen::VectorXd>(value.value.value.content);
    if (known == all.end() && asks_for(block, value.target.index))
      refuse_structure(block, "initial", "where the file gives none, the state begins as the input says");
    const SignalSlot slot = plan_.blocks[block].states[static_cast<std::size_t>(value.target.index)];
    if (known == all.end() ? numbers.size() != 1 : numbers.size() != known->value.size())
      refuse_structure(block, "initial", "the value has another number of elements");
    check_unit(value, known == all.end() ? std::nullopt : known->dimension,
               known == all.end() ? diagram::EachUnit{} : known->each, "initial");
    change_.initial.emplace_back(slot, numbers);
  }

  void set_constant(const diagram::ChangedValue& value) {
    const auto block = static_cast<std::size_t>(value.target.block);
    const auto input = static_cast<std::size_t>(value.target.index);
    const auto element = static_cast<std::size_t>(value.target.element);
    const diagram::Source& known = block_of(value.target).inputs[input][element];
    const auto& numbers = std::get<Eigen::VectorXd>(value.value.value.content);
    const std::string& name = block_of(value.target).type().inputs[input].name;
    check_unit(value, known.dimension, known.each, name);
    if (numbers.size() != known.constant.size() || value.value.columns != known.columns)
      return refuse_structure(block, name, "the value has another number of elements");
    if (configures(block, name, numbers))
      return refuse_structure(block, name, "the memory or the sizes of the block follow from it");
    const SignalSlot meant = constant_slot(known);
    change_.constants.emplace_back(plan_.blocks[block].inputs[input][element],
                                   numbers.segment(static_cast<Eigen::Index>(meant.offset), meant.size));
  }

  /// True where configure() answers differently for this constant than for that of the plan.
  bool configures(std::size_t block, const std::string& input, const Eigen::VectorXd& numbers) const {
    const PlannedBlock& planned = plan_.blocks[block];
    if (!planned.configuration || !planned.written || numbers.size() != 1) return false;
    AnyBlock before = *planned.written, after = *planned.written;
    yaml::Faults faults;
    const bool is_same = configure(plan_, block, before.get(), faults) ==
                         configure(plan_, block, after.get(), faults, {{input, numbers[0]}});
    return !is_same || !faults.empty() || !has_same_members(before, after);
  }

  void rebuild(std::size_t block, AnyBlock written) {
    const PlannedBlock& planned = plan_.blocks[block];
    AnyBlock made = written;
    if (planned.configuration && !fits(configure(plan_, block, made.get(), faults_), *planned.configuration))
      refuse_structure(block, "configure", "sizes, units or what depends on what become others");
    if (!faults_.empty()) return;
    fit_sizes(block, made);
    prepare(plan_, block, made.get());
    if (const auto other = changed_beside(block, written, made))
      refuse_structure(block, *other, "it follows from the parameters that are set");
    if (outline_of(made) != outline_of(plan_.diagram.blocks[block].block))
      refuse_structure(block, "members",
                       "a list begins or ceases to be a single number, or a formula changes");
    change_.blocks.push_back({block, std::move(written), std::move(made)});
  }

  /// Returns the name of a parameter that configure() changed although it was not set; std::nullopt without
  /// one. Compiled code has the value of the plan for it.
  std::optional<std::string> changed_beside(std::size_t block, const AnyBlock& written,
                                            const AnyBlock& made) const {
    const AnyBlock& plan_made = plan_.diagram.blocks[block].block;
    const AnyBlock& plan_written = plan_.blocks[block].written ? *plan_.blocks[block].written : plan_made;
    for (const ParameterSpec& spec : made.type().parameters) {
      if (spec.member < 0) continue;
      const MemberSpec& member = made.type().members[static_cast<std::size_t>(spec.member)];
      const bool was_set = !(items_of(member, written) == items_of(member, plan_written));
      if (!was_set && !(items_of(member, made) == items_of(member, plan_made))) return spec.name;
    }
    return std::nullopt;
  }

  /// Repeats numbers for every element as in the plan: for new values and for those repeated in the plan. The
  /// sizes of all other values stay.
  void fit_sizes(std::size_t block, AnyBlock& made) {
    const diagram::DiagramBlock& known = plan_.diagram.blocks[block];
    for (std::size_t p = 0; p < known.type().parameters.size(); ++p) {
      const ParameterSpec& spec = known.type().parameters[p];
      if (spec.shape.empty()) continue;
      const Value value = spec.get(made.get());
      const Eigen::Index size = size_of(spec.get(known.block.get()));
      const bool was_spread = std::ranges::count(known.spread, p) > 0;
      if (was_spread && is_one_number(value, size))
        spread(made, spec, size);
      else if (was_spread || size_of(value) != size)
        refuse_structure(block, spec.name, "the value has another number of elements");
    }
    for (std::size_t s = 0; s < known.type().sizes.size(); ++s)
      known.type().sizes[s].set(made.get(), plan_.blocks[block].sizes[s]);
  }

  const Plan& plan_;
  const WrittenBlocks& written_;
  WrittenBlocks changed_;
  PlanChange change_;
  yaml::Faults faults_;
};

}  // namespace

PlanChange change_of(const Plan& plan, const std::vector<diagram::ChangedValue>& values,
                     const WrittenBlocks& written) {
  Changing changing(plan, written);
  for (const diagram::ChangedValue& value : values) changing.add(value);
  return changing.take();
}

}  // namespace stepwire::plan
